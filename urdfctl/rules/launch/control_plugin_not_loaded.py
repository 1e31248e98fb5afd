"""UC643."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.simulator_plugins import written_plugins
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.launch.common import hosts_no_manager, is_sure, launch_of

_LAUNCH = """
            <launch>
              <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
              <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>
              <node name="spawner" pkg="controller_manager" type="spawner" args="joint_state_controller"/>%s
            </launch>
"""
_BESIDE = """
              <node name="rviz" pkg="rviz" type="rviz"/>
              <node name="map" pkg="tf" type="static_transform_publisher" args="0 0 0 0 0 0 base map 100"/>
              <node name="wave" pkg="arm" type="wave.py"/>
              <node name="slam" pkg="gmapping" type="slam_gmapping"/>"""
_DRIVER = """
              <node name="hand" pkg="arm" type="hand_hw_node"/>"""
_MANIFEST = "<package><name>arm</name><exec_depend>controller_manager</exec_depend><exec_depend>gazebo_ros</exec_depend></package>"
_PLUGIN = '<gazebo><plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/></gazebo>'
_ROBOT = '%s<link name="base"/>%s</robot>'


@rule(
    "UC643",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    options=["--distro=noetic"],
    whole_robot=True,
    in_library=False,
    authority="gazebo_ros_control README: the plugin 'parses the transmission tags and loads the appropriate hardware "
    "interfaces and controller manager'; spawner: 'Controller Spawner couldn't find the expected controller_manager ROS "
    "interface'",
    bad=[
        {"robot.urdf": _ROBOT % ('«<robot name="arm">»', ""), "arm.launch": _LAUNCH % "", "package.xml": _MANIFEST},
        {
            "robot.urdf": _ROBOT % ('«<robot name="arm">»', ""),
            "arm.launch": _LAUNCH % _BESIDE,
            "package.xml": _MANIFEST,
        },
    ],
    good=[
        {"robot.urdf": _ROBOT % ('<robot name="arm">', _PLUGIN), "arm.launch": _LAUNCH % "", "package.xml": _MANIFEST},
        {"robot.urdf": _ROBOT % ('<robot name="arm">', ""), "arm.launch": _LAUNCH % _DRIVER, "package.xml": _MANIFEST},
    ],
)
def control_plugin_not_loaded(project: Project) -> Iterator[Finding]:
    """Controllers are spawned in Gazebo, but no plugin of the robot runs them.

    In ROS 1 the controller manager of a simulated robot runs in the plugin libgazebo_ros_control.so. Without it, the
    spawner waits for half a minute and gives up. Another node that names hardware, a driver or a manager may contain one.
    """
    launch, robot = launch_of(project, 1), whole_robot_in(project)
    if launch is None or robot is None or not is_sure(launch) or not launch.spawns:
        return
    simulation = next((one for one in launch.simulations if one.sure and one.simulator == "gazebo-classic"), None)
    others = [node for node in launch.nodes if not (hosts_no_manager(node) or node.runs("gazebo_ros", "spawn_model"))]
    plugins = written_plugins(project)
    if simulation is None or others or any(plugin.hosts_control or plugin.any is None for plugin in plugins):
        return
    message = "controllers are spawned in Gazebo, but no <plugin> of the robot runs ros_control"
    fix = Fix('add <gazebo><plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/></gazebo>')
    notes = (Note("controllers are spawned here", launch.spawns[0].at), Note("Gazebo is started here", simulation.at))
    yield Finding(robot.at, message, notes, fix)
