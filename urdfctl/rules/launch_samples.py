"""The files of a small arm, used in the examples of the rules on launch files."""

from __future__ import annotations

ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder">
        <command_interface name="position"/>
        <state_interface name="position"/><state_interface name="velocity"/>
      </joint>
      <joint name="elbow">
        <command_interface name="position"/>
        <state_interface name="position"/><state_interface name="velocity"/>
      </joint>
    </ros2_control>
"""
CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        joint_state_broadcaster:
          type: joint_state_broadcaster/JointStateBroadcaster
        arm_controller:
          type: joint_trajectory_controller/JointTrajectoryController
    arm_controller:
      ros__parameters:
        joints: [shoulder, elbow]
        command_interfaces: [position]
        state_interfaces: [position, velocity]
"""
MANIFEST = """
    <package format="3">
      <name>arm</name>
      <exec_depend>controller_manager</exec_depend>
      <exec_depend>joint_state_broadcaster</exec_depend>
      <exec_depend>joint_trajectory_controller</exec_depend>
      <exec_depend>robot_state_publisher</exec_depend>
      <exec_depend>xacro</exec_depend>
    </package>
"""
CLASSIC_PLUGIN = '<gazebo><plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/></gazebo>'
CLASSIC_MANIFEST = """<package><name>arm</name>
<exec_depend>controller_manager</exec_depend>
<exec_depend>gazebo_ros</exec_depend>
<exec_depend>gazebo_ros_control</exec_depend>
<exec_depend>joint_state_controller</exec_depend>
</package>"""
PUBLISHER = """
      <node pkg="robot_state_publisher" exec="robot_state_publisher">
        <param name="robot_description" value="$(command 'xacro $(find-pkg-share arm)/arm.urdf')" type="str"/>
      </node>"""
MANAGER = """
      <node pkg="controller_manager" exec="ros2_control_node">
        <param from="$(find-pkg-share arm)/controllers.yaml"/>
        <remap from="~/robot_description" to="/robot_description"/>
      </node>"""
FILE = "-p $(find-pkg-share arm)/controllers.yaml"


def spawner(args: str, program: str = "spawner") -> str:
    """Return a spawner node with the given arguments."""
    return f"""
      <node pkg="controller_manager" exec="{program}" args="{args}"/>"""


BROADCASTER = spawner("joint_state_broadcaster")
ARM = spawner(f"arm_controller {FILE}")


def launched(*nodes: str, controllers: str = CONTROLLERS, robot: str = ROBOT) -> dict[str, str]:
    """Return the files of the arm, with a launch file that starts the given nodes."""
    return {
        "arm.launch.xml": f"""
    <launch>{"".join(nodes)}
    </launch>
""",
        "controllers.yaml": controllers,
        "arm.urdf": robot,
        "package.xml": MANIFEST,
    }


SOUND = launched(PUBLISHER, MANAGER, BROADCASTER, ARM)
