"""UC412."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC412",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Sequences can only be values and not keys in params'",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.xacro": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                    <parameters>$(find arm)/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
            "controllers.yaml": """
                «- controller_manager»
            """,
            "package.xml": """<package><name>arm</name></package>""",
        },
    ],
    good=[
        {
            "robot.xacro": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                    <parameters>$(find arm)/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
            """,
            "package.xml": """<package><name>arm</name></package>""",
        },
    ],
)
def controllers_file_not_a_map(project: Project) -> Iterator[Finding]:
    """Controller file is not a map.

    Parameters have names, so a parameter file must be a map of `name: value`, not a list or a string. A node that gets
    another file exits.
    """
    for fault in faults(project, FaultKind.ROOT):
        yield Finding(fault.at, "controller file is not a map; a parameter file requires 'name: value' lines")
