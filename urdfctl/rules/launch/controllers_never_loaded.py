"""UC625."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import control_plugins
from urdfctl.model.launch import Launch, Spawn
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.launch.common import ROS_2, is_sure, manager_nodes
from urdfctl.rules.launch.steps import started_apart
from urdfctl.rules.launch_samples import BROADCASTER, CLASSIC_MANIFEST, CLASSIC_PLUGIN, PUBLISHER, SOUND, launched
from urdfctl.source.span import Place

_BARE = """
      <node pkg="controller_manager" exec="ros2_control_node">
        <remap from="~/robot_description" to="/robot_description"/>
      </node>"""
_MARKED = BROADCASTER.replace('"joint_state_broadcaster"', '"«joint_state_broadcaster»"')
_LOADS = r"rosparam[\s\S]{0,200}load|rosparam\.(?:set|upload|load)|set_param|\.ya?ml"
_ROS_1 = """
            <launch>
              <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>%s
              <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>
              <node name="spawner" pkg="controller_manager" type="spawner" args="%s"/>
            </launch>
"""
_LOADED = '\n<rosparam command="load" file="$(find arm)/controllers.yaml"/>'


def _without_files(*nodes: str) -> dict[str, str]:
    return {name: text for name, text in launched(*nodes).items() if name != "controllers.yaml"}


def _of_ros1(loaded: str, spawned: str) -> dict[str, str]:
    files = {"robot.urdf": CLASSIC_PLUGIN, "arm.launch": _ROS_1 % (loaded, spawned), "package.xml": CLASSIC_MANIFEST}
    return {**files, "options": "--distro=noetic"}


@rule(
    "UC625",
    severity=Severity.ERROR,
    runtime="refuses",
    whole_robot=True,
    in_library=False,
    authority="ros2_control controller_manager.cpp: 'The 'type' param was not defined for 'arm'.'; ros_control "
    "controller_manager.cpp: 'Could not load controller 'arm' because the type was not specified. Did you load the "
    "controller configuration on the parameter server'",
    bad=[
        _without_files(PUBLISHER, _BARE, _MARKED),
        _of_ros1("", "«states»"),
        {**_of_ros1("", "«states»"), "world.launch": _ROS_1 % (_LOADED, "states")},
    ],
    good=[
        SOUND,
        {
            **_of_ros1(_LOADED, "states"),
            "controllers.yaml": "states: {type: joint_state_controller/JointStateController, publish_rate: 50}\n",
        },
        {**_of_ros1("", "states"), "README.md": "rosparam load config/controllers.yaml\n"},
    ],
)
def controllers_never_loaded(project: Project) -> Iterator[Finding]:
    """Controllers are spawned, but no parameters are loaded for them.

    The controller manager finds no type for the controllers and refuses to load them. In ROS 2 the node ros2_control_node gets the
    controller file in its `parameters`; in ROS 1 `<rosparam command="load">` loads it. Another launch file, a script or a README
    may do that: then nothing is reported. A launch file that starts a simulator of its own does it for its own robot.
    """
    launch = project.launch
    if launch is None or not is_sure(launch) or launch.loads or launch.inline or launch.given:
        return
    spawns = [spawn for spawn in launch.spawns if spawn.names and not _is_given(spawn)]
    if not spawns or len(spawns) < len(launch.spawns):
        return
    yield from _of_node(launch, spawns) if launch.ros == ROS_2 else _of_server(project, launch, spawns)


def _is_given(spawn: Spawn) -> bool:
    """Whether a spawner itself gives the manager parameters."""
    return bool(spawn.files) or spawn.option("-t", "--controller-type", "-p", "--param-file") is not None


def _of_node(launch: Launch, spawns: list[Spawn]) -> Iterator[Finding]:
    nodes = manager_nodes(launch)
    bare = [node for node in nodes if node.sure and node.complete and not node.files]
    values = {word.text for node in nodes for word in node.parameters} - {
        "robot_description",
        "use_sim_time",
        "update_rate",
    }
    if bare and len(bare) == len(nodes) and not values:
        message = f"{_spawned(spawns)} spawned, but 'ros2_control_node' gets no controller file in its parameters"
        yield Finding(_first(spawns), message, (Note("it is started here", bare[0].at),))


def _of_server(project: Project, launch: Launch, spawns: list[Spawn]) -> Iterator[Finding]:
    simulated = any(simulation.sure for simulation in launch.simulations) and control_plugins(project)
    if simulated and not project.may_mention(_LOADS, started_apart(launch)):
        message = (
            f'{_spawned(spawns)} spawned, but nothing here loads parameters for them; add <rosparam command="load">'
        )
        yield Finding(_first(spawns), message)


def _spawned(spawns: list[Spawn]) -> str:
    names = list(dict.fromkeys(name for spawn in spawns for name, _ in spawn.names))
    return f"controllers {in_words(names, 3)} are" if len(names) > 1 else f"controller {in_words(names)} is"


def _first(spawns: list[Spawn]) -> Place:
    return spawns[0].names[0][1]
