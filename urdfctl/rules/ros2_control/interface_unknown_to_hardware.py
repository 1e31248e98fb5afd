"""UC355."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.hardware import HardwareType
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known, label, severity_where
from urdfctl.rules.ros2_control.common import called, known_hardware, parts
from urdfctl.suggest import did_you_mean


@rule(
    "UC355",
    severity=Severity.ERROR,
    distros=ROS2,
    authority='ros2_control hardware_interface/src/resource_manager.cpp: "Wrong state or command interface '
    'configuration. missing command interfaces: elbow/acceleration"',
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow">
                <command_interface name="«acceleration»"/>
                <state_interface name="position"/>
              </joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow">
                <command_interface name="effort"/>
                <state_interface name="position"/>
              </joint>
            </ros2_control>
            <gazebo>
              <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                <parameters>/opt/arm/controllers.yaml</parameters>
              </plugin>
            </gazebo>
        """,
    },
)
def interface_unknown_to_hardware(project: Project) -> Iterator[Finding]:
    """A joint has an interface that its hardware does not export.

    A simulator knows position, velocity and effort, and Gazebo Classic two with a PID besides. Any other is missing
    when the interfaces are compared with the description, which is then refused.
    """
    for control, part in parts(project, "joint"):
        found = known_hardware(project, control)
        for interface in part.interfaces if found else ():
            name = (interface.name or "").strip()
            if not name or not is_known(name):
                continue
            lists = [_exported(each, interface.kind) for each in found]
            if any(each is None or name in each for each in lists):
                continue
            there = lists[-1] or ()
            severity = severity_where(project, (each.distro for each in found)) if found[0].host else Severity.WARNING
            reason = did_you_mean(name, there) or f"; it has {in_words(there, len(there))}"
            message = f"'{found[0].type}' has no {called(interface)} for {label('joint', part.name)}{reason}"
            yield Finding(interface.at["name"], message, severity=severity)


def _exported(hardware: HardwareType, kind: str) -> tuple[str, ...] | None:
    """The interfaces of a joint that hardware has; None where it has any, or nobody knows."""
    return hardware.command_interfaces if kind == "command" else hardware.state_interfaces
