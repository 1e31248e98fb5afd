"""UC308."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.diagnostic import Edit
from urdfctl.model.robot import Interface
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known, label
from urdfctl.rules.ros2_control.common import interfaces, whole_element
from urdfctl.rules.ros2_control.facts import INTERFACES_OF_ROS1


@rule(
    "UC308",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "no attribute name in command_interface tag"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    «<command_interface>»position</command_interface>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def interface_without_name(project: Project) -> Iterator[Finding]:
    """Interface without a name.

    The controller manager rejects the whole description. The name is an attribute, not text as in ROS 1's
    `<hardwareInterface>`. An empty name creates an interface that no controller can request.
    """
    for part, interface in interfaces(project):
        of = label(part.kind, part.name)
        if interface.name is None:
            yield Finding(interface.at, f"<{interface.element}> of {of} has no 'name'", fix=_fix(interface))
        elif not interface.name.strip():
            message = f"<{interface.element}> of {of} has an empty 'name'; no controller can request it"
            yield Finding(interface.at["name"], message, severity=Severity.WARNING)


def _fix(interface: Interface) -> Fix | None:
    text = interface.tag.past_comments
    name = INTERFACES_OF_ROS1.get(text.removeprefix("hardware_interface/"), text)
    if not name or not is_known(name):
        return None
    element = f'<{interface.element} name="{name}"/>'
    span = None if interface.tag.children else whole_element(interface.at)
    edits = (Edit(span, element),) if span is not None and name == text else ()
    return Fix(f"write {element}", edits, safe=bool(edits))
