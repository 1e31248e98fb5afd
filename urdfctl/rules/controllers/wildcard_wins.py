"""UC417."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import ValueKind
from urdfctl.rule import Finding, Note, Project, Severity, rule

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
    runtime="ignores",
    distros=ROS2,
    authority="rclcpp rclcpp/src/rclcpp/parameter_map.cpp: sections that match a node are read in file order",
    options=["--distro=jazzy"],
    bad=[{"controllers.yaml": _MANAGER + _ARM % "«[shoulder, elbow]»" + _ALL}],
    good=[{"controllers.yaml": _MANAGER + _ARM % "[shoulder, elbow]"}],
)
def wildcard_wins(project: Project) -> Iterator[Finding]:
    """Section with a wildcard overrides a node's own section.

    ROS 2 reads all sections that match a node in the order of the file. The last value wins, however general its
    section is, and the earlier one is lost. Put sections with wildcards first.
    """
    controllers = controllers_in(project)
    nodes = [(controller.name, controller.own, controller.parameters) for controller in controllers.controllers]
    nodes += [(manager.name, manager.own, manager.parameters) for manager in controllers.managers]
    for name, own, effective in nodes:
        for leaf in own.leaves:
            winner = effective.get(leaf.name)
            if winner is None or winner.value == leaf.value or leaf.value.kind is ValueKind.MAP:
                continue
            if _written(winner.value.text, winner.value.items) != _written(leaf.value.text, leaf.value.items):
                message = f"'{leaf.name}' of '{name}' is overridden by a later section with a wildcard"
                yield Finding(leaf.value.at, message, (Note("this value is used", winner.value.at),))


def _written(text: str, items: tuple[object, ...]) -> tuple[str, tuple[object, ...]]:
    return text, tuple(getattr(item, "text", "") for item in items)
