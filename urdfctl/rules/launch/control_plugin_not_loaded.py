"""UC643."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.simulator_plugins import written_plugins
from urdfctl.control.hosts import hosts_no_manager
from urdfctl.rule import Finding, Fix, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.common import doubt_of, whole_robot_in
from urdfctl.rules.insertions import appended_to_robot
from urdfctl.rules.launch.common import launch_of
from urdfctl.rules.launch_samples import CLASSIC_PLUGIN

_LAUNCH = """
            <launch>
              <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
              <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>
              <node name="spawner" pkg="controller_manager" type="spawner" args="joint_state_controller"/>
            </launch>
"""
_MANIFEST = "<package><name>arm</name><exec_depend>controller_manager</exec_depend><exec_depend>gazebo_ros_control</exec_depend></package>"
_OTHERS = (
    "".join(f"<exec_depend>{name}</exec_depend>" for name in ("rviz", "move_base", "robot_localization")) + "</package>"
)
_BESIDE = (
    '<node name="rviz" pkg="rviz" type="rviz"/>',
    '<node name="wave" pkg="arm" type="wave.py"/>',
    '<node name="watch" pkg="arm" type="watch_arm"/>',
    '<node name="move" pkg="move_base" type="move_base"/>',
    '<node name="pose" pkg="robot_localization" type="ekf_localization_node"/>',
    '<node name="setup" pkg="arm" type="robot_setup.sh"/>',
    '<node name="drive" pkg="arm" type="base_teleop.bash"/>',
    '<node name="states" pkg="robot_state_publisher" type="robot_state_publisher"/>',
)
_HOSTS = tuple(
    f'<node name="arm" pkg="arm" type="{name}"/>'
    for name in (
        "arm_driver arm_hw arm_hardware_node base_node ros_control_arm arm_control_node arm_control_loop "
        "arm_controller_manager robot_main arm_base"
    ).split()
)
_ROBOT = '%s<link name="base"/>%s</robot>'


@rule(
    "UC643",
    severity=Severity.ERROR,
    runtime="refuses",
    stage=StageDependsOn.SPAWNER,
    distros=ROS1,
    options=["--distro=noetic"],
    whole_robot=True,
    in_library=False,
    authority="gazebo_ros_control README: the plugin 'parses the transmission tags and loads the appropriate hardware "
    "interfaces and controller manager'; spawner: 'Controller Spawner couldn't find the expected controller_manager ROS "
    "interface'",
    bad=[
        {"robot.urdf": _ROBOT % ('«<robot name="arm">»', ""), "arm.launch": _LAUNCH, "package.xml": _MANIFEST},
        *(
            {
                "robot.urdf": _ROBOT % ('«<robot name="arm">»', ""),
                "arm.launch": _LAUNCH.replace("</launch>", f"{beside}</launch>"),
                "package.xml": _MANIFEST.replace("</package>", _OTHERS),
            }
            for beside in _BESIDE
        ),
    ],
    good=[
        {
            "robot.urdf": _ROBOT % ('<robot name="arm">', CLASSIC_PLUGIN),
            "arm.launch": _LAUNCH,
            "package.xml": _MANIFEST,
            "README.md": "rosparam load config/controllers.yaml\n",
        },
        *(
            {
                "robot.urdf": _ROBOT % ('<robot name="arm">', ""),
                "arm.launch": _LAUNCH.replace("</launch>", f"{host}</launch>"),
                "package.xml": _MANIFEST,
            }
            for host in _HOSTS
        ),
    ],
)
def control_plugin_not_loaded(project: Project) -> Iterator[Finding]:
    """Controllers are spawned in Gazebo, but no plugin of the robot runs them.

    In ROS 1 the controller manager of a simulated robot runs in the plugin libgazebo_ros_control.so. Without it, the
    spawner waits for half a minute and gives up.
    """
    launch, robot = launch_of(project, 1), whole_robot_in(project)
    doubt = doubt_of(launch) if launch else None
    if launch is None or robot is None or doubt is None:
        return
    spawn = next((spawn for spawn in launch.spawns if spawn.sure), None)
    simulation = next((one for one in launch.simulations if one.sure and one.simulator == "gazebo-classic"), None)
    hosted = any(plugin.hosts_control or plugin.any is None for plugin in written_plugins(project))
    if simulation is None or spawn is None or hosted or not all(map(hosts_no_manager, launch.nodes)):
        return
    message = "controllers are spawned in Gazebo, but no <plugin> of the robot runs ros_control"
    title = 'add <gazebo><plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/></gazebo>'
    fix = Fix(
        title,
        appended_to_robot(robot, _element(spawn.namespace or "")),
        doubt="the plugin may be in a file that is not linted",
    )
    notes = (Note("controllers are spawned here", spawn.at), Note("Gazebo is started here", simulation.at))
    yield Finding(robot.at, message, (*notes, *doubt.notes), fix, doubt.severity)


def _element(namespace: str) -> str:
    """The plugin, as gen-gazebo writes it."""
    robot = f"<robotNamespace>/{namespace.strip('/')}</robotNamespace>"
    return (
        "  <!-- Runs the controllers inside Gazebo. -->\n"
        "  <gazebo>\n"
        '    <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">\n'
        f"      {robot}\n"
        "    </plugin>\n"
        "  </gazebo>\n"
    )
