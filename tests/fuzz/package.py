"""A package with a file of each kind that urdfctl reads. A guided input stands in the place of one of them."""

from __future__ import annotations

import struct

from seeds import OTHER_TEXTS, Tree

_STL = bytes(80) + struct.pack("<I", 1) + struct.pack("<12fH", *(0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0), 0)
_DAE = b"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><translate>1 0 0</translate>
<rotate>0 0 1 90</rotate><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""
_LAUNCH = b"""<launch><arg name="prefix" default=""/>
<rosparam file="$(find arm)/config/controllers.yaml" subst_value="true"/>
<param name="robot_description" command="$(find xacro)/xacro '$(find arm)/urdf/arm.xacro' prefix:=$(arg prefix)"/>
<group ns="a" if="$(eval 1 == 1)"><node name="s" pkg="controller_manager" type="spawner" args="arm --timeout 3"/>
</group><include file="$(find arm)/launch/x.launch" pass_all_args="true"/></launch>
"""
_ROBOT = b"""<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="prefix" default=""/><xacro:property name="size" value="${xacro.load_yaml('../config/sizes.yaml')}"/>
<xacro:include filename="$(find arm)/urdf/wheel.xacro"/><link name="base"><inertial><mass value="${size['mass']}"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial><collision><geometry>
<mesh filename="package://arm/meshes/part.stl" scale="1 1 1"/></geometry></collision><visual><geometry>
<mesh filename="package://arm/meshes/part.dae"/></geometry><material name="grey"><color rgba="0 0 0 1"/></material>
</visual></link><link name="fore"><visual><geometry><mesh filename="package://arm/meshes/part.obj"/></geometry></visual>
</link><joint name="$(arg prefix)elbow" type="revolute"><parent link="base"/><child link="fore"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="${pi / 2}" effort="1" velocity="1"/></joint><xacro:wheel name="left" side="${-1}"/>
<transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="elbow">
<hardwareInterface>EffortJointInterface</hardwareInterface></joint><actuator name="m"/></transmission>
<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
<joint name="$(arg prefix)elbow"><command_interface name="position"/><state_interface name="position"/></joint>
</ros2_control><gazebo><plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
<parameters>$(find arm)/config/controllers.yaml</parameters></plugin></gazebo>
<gazebo reference="fore"><sensor name="s" type="camera"><plugin name="c" filename="libgazebo_ros_camera.so"/></sensor>
</gazebo></robot>
"""
_WHEEL = b"""<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="wheel" params="name side:=1">
<link name="${name}_wheel"><collision><geometry><cylinder radius="0.1" length="0.05"/></geometry></collision></link>
<joint name="${name}_joint" type="continuous"><parent link="base"/><child link="${name}_wheel"/>
<xacro:if value="${side &lt; 0}"><axis xyz="0 1 0"/></xacro:if></joint></xacro:macro></robot>
"""
_PLAIN = b"""<robot name="arm"><link name="base"/><link name="fore"/><joint name="elbow" type="revolute">
<parent link="base"/><child link="fore"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>
"""
_SEMANTIC = b"""<robot name="arm"><group name="all"><chain base_link="base" tip_link="fore"/><joint name="elbow"/>
</group><group_state name="home" group="all"><joint name="elbow" value="0"/></group_state>
<end_effector name="e" parent_link="fore" group="all"/><virtual_joint name="v" type="fixed" parent_frame="world"
child_link="base"/><passive_joint name="elbow"/><disable_collisions link1="base" link2="fore" reason="Never"/></robot>
"""
_WORLD = b"""<?xml version="1.0"?><sdf version="1.6"><world name="w"><include><uri>model://sun</uri></include>
<include><uri>model://table</uri><pose>0 0 1 0 0 0</pose></include><plugin name="g" filename="libgazebo_ros_init.so"/>
<plugin name="o" filename="libown.so"><x>1</x></plugin><gui><plugin name="t" filename="libtime.so"/></gui>
<physics type="ode"><max_step_size>0.001</max_step_size></physics><model name="m"><link name="l"><sensor name="s"
type="ray"><plugin name="p" filename="libgazebo_ros_ray_sensor.so"/></sensor></link></model></world></sdf>
"""
_PLUGINS = b"""<library path="arm_controllers"><class name="arm/Own" type="arm::Own"
base_class_type="controller_interface::ControllerInterface"/><class name="arm/Hardware" type="arm::Hardware"
base_class_type="hardware_interface::SystemInterface"/></library>
"""
_PARAMETERS = b"""own:
  joints: {type: string_array, default_value: [], validation: {not_empty<>: [], unique<>: null}}
  gains: {__map_joints: {p: {type: double, default_value: 1.0, validation: {bounds<>: [0.0, 10.0]}}}}
  mode: {type: string, default_value: a, read_only: true, validation: {one_of<>: [[a, b]]}}
"""
PACKAGE: Tree = {
    **{name: OTHER_TEXTS[name] for name in OTHER_TEXTS if not name.startswith((".git/", "urdf/"))},
    ".git/HEAD": b"ref: refs/heads/main\n",
    "CMakeLists.txt": OTHER_TEXTS["CMakeLists.txt"]
    + b"pluginlib_export_plugin_description_file(controller_interface plugins.xml)\n"
    b"generate_parameter_library(own_parameters src/own.yaml)\n",
    "plugins.xml": _PLUGINS,
    "src/own.yaml": _PARAMETERS,
    "src/own.cpp": b'#include "own_parameters.hpp"\nclass Own : public controller_interface::ControllerInterface {};\n',
    "urdf/arm.xacro": _ROBOT,
    "urdf/wheel.xacro": _WHEEL,
    "moveit/arm.urdf": _PLAIN,
    "moveit/arm.srdf": _SEMANTIC,
    "moveit/joint_limits.yaml": b"joint_limits:\n  elbow: {has_velocity_limits: true, max_velocity: 1.0}\n",
    "moveit/kinematics.yaml": b"all: {kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin}\n",
    "moveit/ompl_planning.yaml": b"planning_plugin: ompl_interface/OMPLPlanner\nall: {planner_configs: [RRT]}\n",
    "moveit/moveit_controllers.yaml": b"moveit_simple_controller_manager:\n  controller_names: [arm]\n"
    b"  arm: {type: FollowJointTrajectory, action_ns: follow_joint_trajectory, default: true, joints: [elbow]}\n",
    "config/sizes.yaml": b"mass: 1.5\nangle: !degrees 90\nwheels: {left: [0, 1], right: [0, -1]}\n",
    "launch/arm.launch": _LAUNCH,
    "launch/x.launch": b"<launch><arg name='prefix'/><param name='a' value='1'/></launch>\n",
    "meshes/part.stl": _STL,
    "meshes/part.obj": b"# part\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "meshes/part.dae": _DAE,
    "worlds/arm.world": _WORLD,
}
