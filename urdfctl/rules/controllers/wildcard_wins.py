"""UC417."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.parameters import Kind
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.controllers.common import controllers_in

_MANAGER = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        arm: {type: forward_command_controller/ForwardCommandController}
"""
_ARM = """
    arm:
      ros__parameters:
        joints: %s
        interface_name: position
"""
_ALL = """
    /**:
      ros__parameters:
        joints: [wrist]
"""


@rule(
    "UC417",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="rclcpp rclcpp/src/rclcpp/parameter_map.cpp: sections that match a node are taken in the order of the file",
    options=["--distro=jazzy"],
    bad={"controllers.yaml": _MANAGER + _ARM % "«[shoulder, elbow]»" + _ALL},
    good={"controllers.yaml": _MANAGER + _ARM % "[shoulder, elbow]"},
)
def wildcard_wins(project: Project) -> Iterator[Finding]:
    """A section with a wildcard gives a node's parameter another value than the node's own section before it.

    The sections that match a node are read in the order of the file, and the last one counts, however general it is: put
    those with wildcards first.
    """
    controllers = controllers_in(project)
    readers = [(one.name, one.own, one.parameters) for one in controllers.controllers]
    readers += [(one.name, one.own, one.parameters) for one in controllers.managers]
    for name, own, reaching in readers:
        for leaf in own.leaves:
            winner = reaching.get(leaf.name)
            if winner is None or winner.value == leaf.value or leaf.value.kind is Kind.MAP:
                continue
            if _said(winner.value.text, winner.value.items) != _said(leaf.value.text, leaf.value.items):
                message = f"'{leaf.name}' of '{name}' is overridden by a section with a wildcard that stands behind it"
                yield Finding(leaf.value.at, message, (Note("this value counts", winner.value.at),))


def _said(text: str, items: tuple[object, ...]) -> tuple[str, tuple[object, ...]]:
    return text, tuple(getattr(item, "text", "") for item in items)
