"""UC338."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since
from urdfctl.model.robot import Ros2Control, Tag
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import respelt
from urdfctl.rules.ros2_control.common import JAZZY, components
from urdfctl.rules.ros2_control.facts import ELEMENTS, ELEMENTS_FROM_JAZZY, INTERFACES_OF_ROS1
from urdfctl.source.opaque import UNKNOWN

_WITH_TEXT = since("humble")
"""Distros in which hardware gets the text of its component."""


@rule(
    "UC338",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: FirstChildElement("...") by exact names; '
    "other elements are silently ignored",
    bad=[
        {
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
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                    «<plugins>»x</plugins>
                    «<parm name="port">»1</parm>
                    «<note>»x</note>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position">«<parm name="min">»-1</parm></command_interface>
                    <state_interface name="position">«<parm name="initial_value">»0</parm></state_interface>
                    «<EffortJointInterface/>»
                    «<hardwareInterface>»hardware_interface/PositionJointInterface</hardwareInterface>
                  </joint>
                  <sensor name="tip"><state_interface name="force"/>«<parm name="frame">»tip</parm></sensor>
                  <gpio name="io"><state_interface name="on"/>«<parm name="pin">»1</parm></gpio>
                  <transmission name="drive">
                    <plugin>transmission_interface/SimpleTransmission</plugin>
                    <joint name="elbow">«<mechanical_reducton>»1</mechanical_reducton>«<offsets>»0</offsets></joint>
                    <actuator name="motor">«<mechanicalReduction>»1</mechanicalReduction></actuator>
                    «<actuators name="other"/>»
                    «<parm name="ratio">»2</parm>
                  </transmission>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                    «<group>»arms</group>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position">«<limits enable="true"/>»</command_interface>
                    <state_interface name="position">«<limits enable="true"/>»</state_interface>
                    «<limits enable="true"/>»
                  </joint>
                  <sensor name="tip"><state_interface name="force"/>«<limits enable="true"/>»</sensor>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>arm_driver/ArmHardware</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    «<state_interfaces name="position"/>»
                    <state_interface name="velocity"/>
                    «<bus_module name="1"/>»
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
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                    <group>arms</group>
                    <param name="calculate_dynamics">true</param>
                  </hardware>
                  <joint name="elbow">
                    <command_interface name="position"><limits enable="true"/></command_interface>
                    <state_interface name="position"><limits enable="true"/></state_interface>
                    <limits enable="true"/>
                  </joint>
                  <sensor name="tip">
                    <state_interface name="force"><param name="unit">N</param></state_interface>
                    <limits enable="true"/>
                    <param name="frame">tip</param>
                  </sensor>
                  <gpio name="io"><state_interface name="on"/><param name="pin">1</param></gpio>
                </ros2_control>
            """,
        },
    ],
)
def element_not_read(project: Project) -> Iterator[Finding]:
    """Ignored element in a component.

    The parser ignores the element without a message, and its content has no effect. Some elements are read only since
    jazzy: `<limits>` in joints and interfaces, `<group>` in `<hardware>`. From humble on hardware gets the whole text of its
    component, so a driver that is not in the catalogue may read elements of its own, as that for EtherCAT does: this is
    only worth knowing.
    """
    for control in components(project):
        for tag, inside in _elements(control):
            known, later = ELEMENTS[inside], ELEMENTS_FROM_JAZZY.get(inside, ())
            for child in tag.children:
                if child.name in known or child.name == UNKNOWN or ":" in child.name or _is_role(child, tag):
                    continue
                if child.name not in later:
                    meant = nearest(child.name, known)
                    hint = f"; did you mean '{meant}'?" if meant else _hint(child.name, inside)
                    if meant is None and "transmission" not in inside and _may_read(project, control):
                        message = f"<{child.name}> in <{tag.name}> is ignored, unless the hardware reads it itself"
                        yield Finding(child.at, message, severity=Severity.INFO)
                        continue
                    message = f"<{child.name}> in <{tag.name}> is ignored{hint}"
                    yield Finding(child.at, message, fix=respelt(child, meant))
                elif not set(JAZZY) & set(project.distros):
                    message = f"<{child.name}> in <{tag.name}> is ignored before jazzy"
                    yield Finding(child.at, message, severity=Severity.INFO)


def _elements(control: Ros2Control) -> Iterator[tuple[Tag, str]]:
    """The elements whose children the parser reads by name, each with its key in ELEMENTS."""
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


def _may_read(project: Project, control: Ros2Control) -> bool:
    """Whether hardware that is not in the catalogue may read elements of its own from HardwareInfo::original_xml."""
    plugin = control.plugin or ""
    known = any(project.catalog.hardware(plugin.strip(), distro) for distro in ROS2)
    return not known and any(distro in _WITH_TEXT for distro in project.distros)


def _is_role(child: Tag, tag: Tag) -> bool:
    """Whether a child is a role that should be an attribute: another rule reports it."""
    return child.name == "role" and "role" not in tag.attributes


def _hint(name: str, inside: str) -> str:
    if name in INTERFACES_OF_ROS1 or name == "hardwareInterface":
        return "; it is a ROS 1 element. Use <command_interface> and <state_interface>"
    return '; pass values to the hardware with <param name="...">' if "transmission" not in inside else ""
