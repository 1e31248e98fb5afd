"""UC522."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import controllers_files


@rule(
    "UC522",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="gz_ros2_control and gazebo_ros2_control hand the text to rcl as --params-file: 'Error opening YAML file'",
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                <parameters>«config/controllers.yaml»</parameters>
              </plugin>
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                <parameters>/opt/arm/controllers.yaml</parameters>
              </plugin>
            </gazebo>
        """,
    },
)
def controllers_path_relative(project: Project) -> Iterator[Finding]:
    """A simulator's plugin is given the controllers' file by a relative path, or by an address.

    A relative path is looked for where the simulator was started, and there alone. Addresses like `package://` mean
    nothing here.
    """
    for one, _, reference in controllers_files(project):
        text = reference.text
        if text.startswith("/") or "$" in text or not is_known(text):
            continue
        address = "://" in text
        message = f"'{one.filename}' looks for '{text}' in the folder where the simulator is started"
        if address:
            message = f"'{one.filename}' knows no addresses, and finds no file '{text}'"
        fix = Fix("write $(find your_package)/... in a .xacro file")
        yield Finding(reference.at, message, fix=fix, severity=Severity.ERROR if address else None)
