"""UC345."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, replaced
from urdfctl.rules.ros2_control.common import called, parts
from urdfctl.rules.ros2_control.facts import INTERFACES_OF_ROS1
from urdfctl.suggest import nearest

_STANDARD = ("position", "velocity", "effort", "acceleration")


@rule(
    "UC345",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control hardware_interface/include/hardware_interface/types/hardware_interface_type_values.hpp "
    "has the names that controllers ask for; any other is one of the hardware's own",
    bad={
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
def interface_name_misspelt(project: Project) -> Iterator[Finding]:
    """An interface of a joint is spelt nearly like one that controllers ask for, or as ROS 1 has it.

    It is taken as an interface of the hardware's own, and the controller that asks for position, velocity or effort
    does not find it.
    """
    for _, part in parts(project, "joint"):
        for interface in part.interfaces:
            name = (interface.name or "").strip()
            meant = INTERFACES_OF_ROS1.get(name.rsplit("/")[-1]) or _meant(name)
            if not is_known(name) or meant is None:
                continue
            at = interface.at["name"]
            message = f"{called(interface)} of {label('joint', part.name)} is none of ROS 2's; did you mean '{meant}'?"
            yield Finding(at, message, fix=replaced(at, interface.name or "", meant))


def _meant(name: str) -> str | None:
    if any(word in name.lower() and name.lower() != word for word in _STANDARD) or name in _STANDARD:
        return None
    return nearest(name, _STANDARD)
