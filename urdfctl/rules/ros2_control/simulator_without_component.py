"""UC361."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in

_PLUGINS = ("gazebo_ros2_control", "gz_ros2_control", "ign_ros2_control")


@rule(
    "UC361",
    severity=Severity.ERROR,
    runtime="drops",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "no ros2_control tag"; '
    'gazebo_ros2_control: "Error parsing URDF in gazebo_ros2_control plugin, plugin not active"',
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  «<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">»
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <gazebo>
                  «<plugin filename="libgazebo_ros2_control.so" name="control">»
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <gazebo>
                  «<plugin filename="ign_ros2_control-system" name="control">»
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <gazebo>
                  <plugin filename="gz-sim-joint-state-publisher-system" name="gz::sim::systems::JointStatePublisher"/>
                </gazebo>
            """,
        },
    ],
)
def simulator_without_component(project: Project) -> Iterator[Finding]:
    """Simulator plugin for ros2_control without a `<ros2_control>`.

    The plugin finds nothing to control and stays inactive: there is no controller manager. Before foxy, the plugin read
    transmissions instead.
    """
    robot = whole_robot_in(project)
    if robot is None or robot.ros2_controls or any("ros2_control" in tag.name.lower() for tag in robot.others):
        return
    for plugin in robot.plugins:
        if any(name in (plugin.filename or "") for name in _PLUGINS):
            message = f"plugin '{plugin.filename}' requires a <ros2_control>, but the robot has none"
            severity = Severity.WARNING if robot.transmissions else Severity.ERROR
            yield Finding(plugin.at, message, severity=severity)
