"""A package of ROS 1 with files in many folders."""

from __future__ import annotations

from ros1_packages import MANIFEST, PLUGIN, arm, transmission

CONTROLLERS = """\
arm:
  joint_states:
    type: joint_state_controller/JointStateController
    publish_rate: 50
  ctl:
    type: effort_controllers/JointPositionController
    joint: shoulder
    pid: {p: 1, i: 0, d: 0.1}
"""
LAUNCH = """\
<launch>
  <!-- what a user may choose
       at the start -->
  <arg name="gui" default="true" doc="false: without a 'window'"/>
  <arg name="paused" default="false"/>
  <arg name="ns" default="arm"/>
  <arg name="left" value="$(eval arg('ns') + '_left')"/>
  <arg name="world" default="worlds/empty.world"/>
  <arg name="simulated"/>
  <arg name="controllers" default="joint_states ctl"/>
  <param name="use_sim_time" value="true"/>
  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/urdf/arm.xacro ns:=$(arg ns)"/>
  <param name="/speed" value="1"/>
  <rosparam command="load" file="$(find arm)/config/controllers.yaml"/>
  <include file="$(find gazebo_ros)/launch/empty_world.launch" if="$(arg simulated)">
    <arg name="world_name" value="$(arg world)"/>
    <arg name="gui" value="$(arg gui)"/>
    <arg name="paused" value="$(arg paused)"/>
    <arg name="verbose" value="true"/>
  </include>
  <group ns="$(arg ns)">
    <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm
      -x $(optenv X 0) -z 0.1 -J shoulder 0.5 -J elbow 1"/>
    <node name="ctl" pkg="controller_manager" type="spawner" args="$(arg controllers) --timeout 20"/>
    <node name="rsp" pkg="robot_state_publisher" type="robot_state_publisher" output="screen">
      <param name="publish_frequency" value="50"/>
      <remap from="joint_states" to="/$(arg ns)/joint_states"/>
    </node>
  </group>
  <node name="rviz" pkg="rviz" type="rviz" args="-d $(dirname)/arm.rviz" unless="$(arg simulated)"/>
  <include file="$(find arm)/launch/other.launch"><arg name="frame" value="$(env FRAME)"/></include>
</launch>
"""
OTHER = '<launch>\n  <arg name="frame"/>\n</launch>\n'
FILES = {
    "arm/package.xml": MANIFEST,
    "arm/urdf/arm.xacro": arm(transmission("EffortJointInterface"), PLUGIN),
    "arm/config/controllers.yaml": CONTROLLERS,
    "arm/launch/arm.launch": LAUNCH,
    "arm/launch/other.launch": OTHER,
}
