"""UC338."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.parts import Tag
from urdfctl.model.ros2_control import Ros2Control
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import respelt
from urdfctl.rules.ros2_control.common import JAZZY, components
from urdfctl.rules.ros2_control.facts import ELEMENTS, ELEMENTS_FROM_JAZZY, INTERFACES_OF_ROS1
from urdfctl.source.opaque import UNKNOWN
from urdfctl.suggest import nearest


@rule(
    "UC338",
    severity=Severity.WARNING,
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: FirstChildElement("...") by exact names; '
    "other elements are passed over without a word",
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow">
                <command_interface name="position"/>
                «<state_interfaces name="position"/>»
                <state_interface name="velocity"/>
              </joint>
            </ros2_control>
        """,
    },
    good={
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
)
def element_not_read(project: Project) -> Iterator[Finding]:
    """An element stands in a part of a component that is not read there.

    Nobody tells of it: what it should say is just not there. Some elements are read from jazzy on: `<limits>` in
    joints and interfaces, `<group>` in `<hardware>`.
    """
    for control in components(project):
        for tag, inside in _read(control):
            takes, later = ELEMENTS[inside], ELEMENTS_FROM_JAZZY.get(inside, ())
            for child in tag.children:
                if child.name in takes or child.name == UNKNOWN or ":" in child.name or _is_role(child, tag):
                    continue
                if child.name not in later:
                    meant = nearest(child.name, takes)
                    reason = f"; did you mean '{meant}'?" if meant else _hint(child.name, inside)
                    message = f"<{child.name}> is not read in <{tag.name}>{reason}"
                    yield Finding(child.at, message, fix=respelt(child, meant))
                elif not set(JAZZY) & set(project.distros):
                    message = f"<{child.name}> in <{tag.name}> is read from jazzy on"
                    yield Finding(child.at, message, severity=Severity.INFO)


def _read(control: Ros2Control) -> Iterator[tuple[Tag, str]]:
    """The elements whose children are looked for by name, each with its name; a plugin reads the rest of <hardware>."""
    for hardware in control.hardware:
        if hardware.plugins:
            yield hardware.tag, "hardware"
    for part in control.parts:
        yield part.tag, part.kind
        for interface in part.interfaces:
            yield interface.tag, interface.element
    for transmission in control.transmissions:
        if transmission.plugins:
            yield transmission.tag, "transmission"
            yield from (
                (end.tag, f"{end.kind} of a transmission") for end in (*transmission.joints, *transmission.actuators)
            )


def _is_role(child: Tag, tag: Tag) -> bool:
    """Whether it is the role of a transmission's end, the lack of which as an attribute another rule tells of."""
    return child.name == "role" and "role" not in tag.attributes


def _hint(name: str, inside: str) -> str:
    if name in INTERFACES_OF_ROS1 or name == "hardwareInterface":
        return ", which is ROS 1's; there are <command_interface> and <state_interface>"
    return '; what the hardware is to know stands in <param name="...">' if "transmission" not in inside else ""
