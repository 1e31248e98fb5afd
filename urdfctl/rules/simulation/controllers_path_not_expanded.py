"""UC521."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import controllers_files


@rule(
    "UC521",
    runtime="refuses",
    because="the launch file may run xacro on it",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros-controls/gazebo_ros2_control#141 and #155: 'Error opening YAML file' with the literal '$(find ...)': only "
    "xacro expands it",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>«$(find arm)/config/controllers.yaml»</parameters>
                  </plugin>
                </gazebo>
            """,
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
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>$(find arm)/config/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
            "package.xml": "<package><name>arm</name></package>",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_state_broadcaster:
                      type: joint_state_broadcaster/JointStateBroadcaster
            """,
        },
    ],
)
def controllers_path_not_expanded(project: Project) -> Iterator[Finding]:
    """Expression in the path of the controller file is not expanded.

    Only xacro expands `$(find ...)` and `${...}`. In a plain URDF, the simulator looks for a file with exactly that
    name. This works only if the launch file runs xacro on the URDF anyway. Nothing expands `$HOME` and `~`: an error.
    """
    for sim_plugin, _, reference in controllers_files(project):
        text = reference.text
        if not is_known(text):
            continue
        problem = f"'{text}' is not expanded, and '{sim_plugin.filename}' finds no file of that name"
        if "$(" in text or "${" in text:
            fix = Fix("rename the file to .xacro and run xacro in the launch file, or write the absolute path")
            yield Finding(reference.at, f"{problem}; only xacro expands it", fix=fix)
        elif text.startswith("~") or "$" in text:
            fix = Fix("write $(find your_package)/... in a .xacro file")
            yield Finding(reference.at, f"{problem}; only a shell expands it", fix=fix, severity=Severity.ERROR)
