"""UC621."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import control_plugins
from urdfctl.control.hosts import hosts_no_manager
from urdfctl.control.model_spawners import model_spawners
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.launch.common import ROS_2, manager_nodes
from urdfctl.rules.launch.steps import SPAWNS_CONTROLLERS, declared_controllers, started_apart
from urdfctl.rules.launch_samples import ARM, BROADCASTER, CONTROLLERS, MANAGER, PUBLISHER, SOUND, launched
from urdfctl.source.span import Place

_MARKED = CONTROLLERS.replace("    joint_state_broadcaster:", "    «joint_state_broadcaster»:", 1)
_SIMULATED = """
            <launch>
              <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
              <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>
              <rosparam command="load" file="$(find arm)/controllers.yaml"/>%s
            </launch>
"""
_MANIFEST = "<package><name>arm</name>" + "".join(
    f"<exec_depend>{name}</exec_depend>"
    for name in ("controller_manager", "gazebo_ros_control", "joint_state_controller")
)
_OF_ROS_1 = {
    "robot.urdf": '<gazebo><plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so"/></gazebo>',
    "package.xml": f"{_MANIFEST}</package>",
}
_STATES = "%s: {type: joint_state_controller/JointStateController, publish_rate: 50}\n"
_SPAWNER = '<node name="spawner" pkg="controller_manager" type="spawner" args="states"/>'


@rule(
    "UC621",
    severity=Severity.WARNING,
    runtime="refuses",
    because="somebody may spawn them by hand",
    whole_robot=True,
    in_library=False,
    authority="ros2_control controller_manager.cpp and ros_control controller_manager.cpp: a controller is loaded by the service "
    "load_controller alone, which the spawner calls",
    bad=[
        launched(PUBLISHER, MANAGER, controllers=_MARKED),
        {
            **_OF_ROS_1,
            "arm.launch": _SIMULATED % "",
            "controllers.yaml": _STATES % "«states»",
            "options": "--distro=noetic",
        },
        {**launched(PUBLISHER, MANAGER, controllers=_MARKED), "mock.launch.xml": f"<launch>{MANAGER}{ARM}</launch>"},
        {
            **_OF_ROS_1,
            "arm.launch": _SIMULATED % "",
            "world.launch": _SIMULATED % _SPAWNER,
            "controllers.yaml": _STATES % "«states»",
            "options": "--distro=noetic",
        },
    ],
    good=[
        SOUND,
        launched(PUBLISHER, MANAGER, f'<group if="false">{BROADCASTER}{ARM}</group>'),
        {**launched(PUBLISHER, MANAGER), "spawn.launch.xml": f"<launch>{BROADCASTER}{ARM}</launch>"},
        {**launched(PUBLISHER, MANAGER), "README.md": "ros2 run controller_manager spawner arm_controller\n"},
        {
            **launched(PUBLISHER, MANAGER),
            "start.sh": "ros2 control load_controller arm_controller --set-state active\n",
        },
        {
            **_OF_ROS_1,
            "arm.launch": _SIMULATED % _SPAWNER,
            "controllers.yaml": _STATES % "states",
            "options": "--distro=noetic",
        },
    ],
)
def controllers_never_spawned(project: Project) -> Iterator[Finding]:
    """Controllers that nothing spawns.

    A controller manager starts without controllers. It loads those that a spawner asks for, or a client of its service
    load_controller. No launch file, script or README of the workspace does that: they are
    not loaded, no joint moves, and no joint states are published. A launch file that starts a simulator or manager of its
    own is not started beside this one.
    """
    launch, names = project.launch, list(dict.fromkeys(declared_controllers(project)))
    if launch is None or not launch.complete or launch.spawns or not names:
        return
    manager = _manager(project)
    others = [node for node in launch.nodes if node not in manager_nodes(launch)]
    if (
        manager is None
        or not all(map(hosts_no_manager, others))
        or project.may_mention(SPAWNS_CONTROLLERS, started_apart(launch))
    ):
        return
    controllers = project.controllers.controllers if project.controllers else ()
    at = next(each.declared_at for each in controllers if each.declared_at is not None and each.type is not None)
    kind = "controllers" if len(names) > 1 else "controller"
    message = f"nothing spawns {kind} {in_words(names, 3)}: no launch file, script or README here"
    title = f"add a node 'spawner' of package controller_manager with the arguments {' '.join(names)}"
    yield Finding(at, message, (Note("their controller manager is started here", manager),), Fix(title))


def _manager(project: Project) -> Place | None:
    """The place that certainly starts a controller manager; None if none does."""
    launch = project.launch
    if launch is None:
        return None
    node = next((node for node in manager_nodes(launch) if node.sure), None) if launch.ros == ROS_2 else None
    if node is not None:
        return node.at
    plugin = next(iter(control_plugins(project)), None)
    is_simulated = any(simulation.sure for simulation in launch.simulations) and model_spawners(launch)
    return plugin.plugin.at if plugin is not None and is_simulated else None
