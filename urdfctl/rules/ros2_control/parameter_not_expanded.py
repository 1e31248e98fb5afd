"""UC363."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_xacro, robot_in
from urdfctl.rules.ros2_control.common import parameters


@rule(
    "UC363",
    runtime="misbehaves",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control passes a parameter's text to the hardware unchanged; only xacro expands ${...} and $(...)",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>my_robot/MyHardware</plugin>
                    «<param name="calibration">»$(find my_robot)/config/calibration.yaml</param>
                  </hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>my_robot/MyHardware</plugin>
                    <param name="calibration">config/calibration.yaml</param>
                  </hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def parameter_not_expanded(project: Project) -> Iterator[Finding]:
    """Xacro expression in a parameter is not expanded.

    The hardware receives the text unchanged. The file is not a xacro file: its name does not say so, and it does not
    declare the xacro namespace.
    """
    robot = robot_in(project)
    if robot is None or is_xacro(robot):
        return
    for of, given in parameters(project):
        for parameter in given:
            expression = re.search(r"\$[({][^)}]*[)}]?", parameter.value)
            if expression and parameter.name not in ("min", "max", "initial_value"):
                message = f"'{expression.group()}' in parameter '{parameter.name}' of {of} is not expanded"
                yield Finding(parameter.at, message, fix=Fix("write the value, or convert the file to xacro"))
