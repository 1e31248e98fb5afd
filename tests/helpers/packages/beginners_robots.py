"""Two small packages that work, in which tests plant the mistakes of beginners: a base for noetic, an arm for jazzy."""

from __future__ import annotations

_BODY = """\
      <inertial>
        <mass value="{mass}"/>
        <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
      </inertial>"""

BASE = {
    "urdf/tern.urdf.xacro": f"""\
<?xml version="1.0"?>
<robot name="tern" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="wheel_radius" value="0.06"/>
  <xacro:property name="track" value="0.32"/>

  <link name="base_link">
    <visual><geometry><box size="0.4 0.28 0.1"/></geometry></visual>
    <collision><geometry><box size="0.4 0.28 0.1"/></geometry></collision>
{_BODY.format(mass=4)}
  </link>

  <xacro:macro name="wheel" params="side sign">
    <link name="${{side}}_wheel">
      <visual>
        <origin rpy="${{pi/2}} 0 0"/>
        <geometry><cylinder radius="${{wheel_radius}}" length="0.03"/></geometry>
      </visual>
      <collision>
        <origin rpy="${{pi/2}} 0 0"/>
        <geometry><cylinder radius="${{wheel_radius}}" length="0.03"/></geometry>
      </collision>
{_BODY.format(mass="0.5")}
    </link>
    <joint name="${{side}}_wheel_joint" type="continuous">
      <origin xyz="0 ${{sign*track/2}} -0.05"/>
      <parent link="base_link"/>
      <child link="${{side}}_wheel"/>
      <axis xyz="0 1 0"/>
    </joint>
    <transmission name="${{side}}_wheel_transmission">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="${{side}}_wheel_joint">
        <hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface>
      </joint>
      <actuator name="${{side}}_wheel_motor">
        <mechanicalReduction>1</mechanicalReduction>
      </actuator>
    </transmission>
  </xacro:macro>
  <xacro:wheel side="left" sign="1"/>
  <xacro:wheel side="right" sign="-1"/>

  <link name="caster">
    <collision><geometry><sphere radius="0.03"/></geometry></collision>
{_BODY.format(mass="0.2")}
  </link>
  <joint name="caster_joint" type="fixed">
    <origin xyz="-0.15 0 -0.08"/>
    <parent link="base_link"/>
    <child link="caster"/>
  </joint>
  <gazebo reference="caster"><mu1>0.01</mu1><mu2>0.01</mu2></gazebo>
  <gazebo>
    <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/>
  </gazebo>
</robot>
""",
    "config/controllers.yaml": """\
joint_state_controller:
  type: joint_state_controller/JointStateController
  publish_rate: 50

drive_controller:
  type: diff_drive_controller/DiffDriveController
  left_wheel: left_wheel_joint
  right_wheel: right_wheel_joint
  publish_rate: 50
  wheel_separation: 0.32
  wheel_radius: 0.06
  base_frame_id: base_link
  pose_covariance_diagonal: [0.001, 0.001, 1000000.0, 1000000.0, 1000000.0, 1000.0]
  twist_covariance_diagonal: [0.001, 0.001, 1000000.0, 1000000.0, 1000000.0, 1000.0]
""",
    "launch/sim.launch": """\
<launch>
  <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
  <param name="robot_description" command="$(find xacro)/xacro $(find tern)/urdf/tern.urdf.xacro"/>
  <rosparam command="load" file="$(find tern)/config/controllers.yaml"/>
  <node name="spawn_model" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model tern"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="joint_state_controller drive_controller"/>
  <node name="robot_state_publisher" pkg="robot_state_publisher" type="robot_state_publisher"/>
</launch>
""",
    "package.xml": """\
<package format="2">
  <name>tern</name><version>0.1.0</version><description>A base.</description>
  <maintainer email="you@example.com">you</maintainer><license>MIT</license>
  <buildtool_depend>catkin</buildtool_depend>
  <exec_depend>xacro</exec_depend>
  <exec_depend>gazebo_ros</exec_depend>
  <exec_depend>gazebo_ros_control</exec_depend>
  <exec_depend>controller_manager</exec_depend>
  <exec_depend>joint_state_controller</exec_depend>
  <exec_depend>diff_drive_controller</exec_depend>
  <exec_depend>robot_state_publisher</exec_depend>
</package>
""",
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.0.2)
project(tern)
find_package(catkin REQUIRED)
catkin_package()
install(DIRECTORY urdf config launch DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
""",
}

ARM = {
    "urdf/kite.urdf.xacro": f"""\
<?xml version="1.0"?>
<robot name="kite" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="segment_length" value="0.3"/>
  <xacro:property name="joint_effort" value="40"/>

  <link name="world"/>
  <joint name="mount" type="fixed">
    <parent link="world"/>
    <child link="base"/>
  </joint>
  <link name="base">
{_BODY.format(mass=3)}
  </link>

  <xacro:macro name="segment" params="name parent child axis">
    <joint name="${{name}}" type="revolute">
      <origin xyz="0 0 ${{segment_length}}"/>
      <parent link="${{parent}}"/>
      <child link="${{child}}"/>
      <axis xyz="${{axis}}"/>
      <limit lower="-1.5" upper="1.5" effort="${{joint_effort}}" velocity="2"/>
    </joint>
    <link name="${{child}}">
{_BODY.format(mass=1)}
    </link>
  </xacro:macro>
  <xacro:segment name="shoulder" parent="base" child="upper_arm" axis="0 0 1"/>
  <xacro:segment name="elbow" parent="upper_arm" child="forearm" axis="0 1 0"/>
  <xacro:segment name="wrist" parent="forearm" child="hand" axis="1 0 0"/>

  <ros2_control name="kite_hardware" type="system">
    <hardware>
      <plugin>gz_ros2_control/GazeboSimSystem</plugin>
    </hardware>
    <joint name="shoulder">
      <command_interface name="position"/>
      <state_interface name="position"/>
      <state_interface name="velocity"/>
    </joint>
    <joint name="elbow">
      <command_interface name="position"/>
      <state_interface name="position"/>
      <state_interface name="velocity"/>
    </joint>
    <joint name="wrist">
      <command_interface name="position"/>
      <state_interface name="position"/>
      <state_interface name="velocity"/>
    </joint>
  </ros2_control>

  <gazebo>
    <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
      <parameters>$(find kite)/config/controllers.yaml</parameters>
    </plugin>
  </gazebo>
</robot>
""",
    "config/controllers.yaml": """\
controller_manager:
  ros__parameters:
    update_rate: 100
    joint_state_broadcaster:
      type: joint_state_broadcaster/JointStateBroadcaster
    arm_controller:
      type: joint_trajectory_controller/JointTrajectoryController

arm_controller:
  ros__parameters:
    joints:
      - shoulder
      - elbow
      - wrist
    command_interfaces:
      - position
    state_interfaces:
      - position
      - velocity
""",
    "launch/sim.launch.py": """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    share = get_package_share_directory("kite")
    model = os.path.join(share, "urdf", "kite.urdf.xacro")
    description = ParameterValue(Command(["xacro ", model]), value_type=str)
    world = os.path.join(get_package_share_directory("ros_gz_sim"), "launch", "gz_sim.launch.py")
    return LaunchDescription(
        [
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(world), launch_arguments={"gz_args": "-r empty.sdf"}.items()
            ),
            Node(
                package="ros_gz_bridge",
                executable="parameter_bridge",
                arguments=["/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"],
            ),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description, "use_sim_time": True}],
            ),
            Node(package="ros_gz_sim", executable="create", arguments=["-topic", "robot_description"]),
            Node(
                package="controller_manager",
                executable="spawner",
                arguments=["joint_state_broadcaster", "arm_controller"],
            ),
        ]
    )
""",
    "package.xml": """\
<package format="3">
  <name>kite</name><version>0.1.0</version><description>An arm.</description>
  <maintainer email="you@example.com">you</maintainer><license>MIT</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <exec_depend>xacro</exec_depend>
  <exec_depend>ros_gz_sim</exec_depend>
  <exec_depend>ros_gz_bridge</exec_depend>
  <exec_depend>gz_ros2_control</exec_depend>
  <exec_depend>controller_manager</exec_depend>
  <exec_depend>joint_state_broadcaster</exec_depend>
  <exec_depend>joint_trajectory_controller</exec_depend>
  <exec_depend>robot_state_publisher</exec_depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
""",
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.8)
project(kite)
find_package(ament_cmake REQUIRED)
install(DIRECTORY urdf config launch DESTINATION share/${PROJECT_NAME})
ament_package()
""",
}
