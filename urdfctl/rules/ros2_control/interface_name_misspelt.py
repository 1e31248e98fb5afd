"""UC345."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import ComponentPart, Interface
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, replaced
from urdfctl.rules.ros2_control.common import called, interfaces_exported, known_hardware, parts
from urdfctl.rules.ros2_control.facts import INTERFACES_OF_ROS1

if TYPE_CHECKING:
    from urdfctl.catalog.hardware import HardwareType

_STANDARD = ("position", "velocity", "effort", "acceleration")


@rule(
    "UC345",
    runtime="misbehaves",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control hardware_interface/include/hardware_interface/types/hardware_interface_type_values.hpp "
    "has the names that controllers request; any other name is specific to the hardware",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="«hardware_interface/PositionJointInterface»"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="«postion»"/>
                    <command_interface name="«velocty»"/>
                    <command_interface name="«VelocityJointInterface»"/>
                    <command_interface name="«efort»"/>
                    <command_interface name="«EffortJointInterface»"/>
                    <state_interface name="position"/>
                    <state_interface name="«acceleraton»"/>
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
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="velocity"/>
                    <command_interface name="effort"/>
                    <command_interface name="position_pid"/>
                    <state_interface name="position"/>
                    <state_interface name="acceleration"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def interface_name_misspelt(project: Project) -> Iterator[Finding]:
    """Misspelt interface name of a joint, or a name from ROS 1.

    It is treated as an interface specific to the hardware. A controller that requests position, velocity or effort does
    not find it. A simulator exports no other names than its own: there the fix is safe.
    """
    for control, part in parts(project, "joint"):
        for interface in part.interfaces:
            name = (interface.name or "").strip()
            meant = INTERFACES_OF_ROS1.get(name.rsplit("/")[-1]) or _meant(name)
            if not is_known(name) or meant is None:
                continue
            at = interface.at["name"]
            message = f"{called(interface)} of {label('joint', part.name)} is unknown in ROS 2; did you mean '{meant}'?"
            safe = _is_sure(known_hardware(project, control), part, interface, meant)
            yield Finding(at, message, fix=replaced(at, interface.name or "", meant, safe=safe))


def _is_sure(hardware: Iterable[HardwareType], part: ComponentPart, interface: Interface, meant: str) -> bool:
    """Whether the hardware exports what is meant and not what is written, and the joint has no other of that name."""
    exported = [interfaces_exported(each, interface.kind) for each in hardware]
    others = [other for other in part.interfaces if other.kind == interface.kind and other is not interface]
    is_only = all((other.name or "").strip() != meant for other in others)
    return is_only and bool(exported) and all(names is not None and meant in names for names in exported)


def _meant(name: str) -> str | None:
    if any(word in name.lower() and name.lower() != word for word in _STANDARD) or name in _STANDARD:
        return None
    return nearest(name, _STANDARD)
