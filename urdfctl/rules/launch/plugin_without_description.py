"""UC638."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since, until
from urdfctl.control.hardware.simulator_plugins import LoadedPlugin, control_plugins, namespace_of
from urdfctl.control.model_spawners import model_spawners, option_of
from urdfctl.model.launch import Launch, Node
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.launch.common import ROS_2, launch_of, state_publishers
from urdfctl.rules.launch.steps import PUBLISHES_DESCRIPTION, description_topic
from urdfctl.rules.launch_samples import ARM, BROADCASTER, CONTROLLERS, MANIFEST, PUBLISHER, ROBOT

_PUBLISHER = "robot_state_publisher"
_ELSEWHERE = PUBLISHER.replace("<node ", '<node namespace="left" ')
_RENAMED = PUBLISHER.replace("<node ", '<node name="rsp" ')
_GZ = """
      <include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"><arg name="gz_args" value="-r empty.sdf"/></include>
      <node pkg="ros_gz_bridge" exec="parameter_bridge" args="/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"/>
      <node pkg="ros_gz_sim" exec="create" args="-file $(find-pkg-share arm)/arm.urdf -name arm"/>"""
_DEPENDS = """<exec_depend>ros_gz_sim</exec_depend><exec_depend>ros_gz_bridge</exec_depend>
    <exec_depend>gz_ros2_control</exec_depend>"""
_PLUGIN = '<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'


def _files(*nodes: str, distro: str = "jazzy", mark: tuple[str, str] = ("«", "»")) -> dict[str, str]:
    plugin = f"{mark[0]}{_PLUGIN}{mark[1]}<parameters>/opt/arm/controllers.yaml</parameters></plugin>"
    robot = ROBOT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    return {
        "arm.launch.xml": f"<launch>{''.join((*nodes, _GZ, BROADCASTER, ARM))}\n</launch>",
        "arm.urdf": f"{robot}<gazebo>{plugin}</gazebo>",
        "controllers.yaml": CONTROLLERS,
        "package.xml": MANIFEST.replace("</package>", f"{_DEPENDS}</package>"),
        "options": f"--distro={distro}",
    }


_SOUND = ("", "")


@rule(
    "UC638",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    whole_robot=True,
    in_library=False,
    authority="gz_ros2_control_plugin.cpp Configure(): 'Waiting RM to load and initialize hardware...' until the topic "
    "robot_description comes (jazzy); ign_ros2_control_plugin.cpp and gazebo_ros2_control_plugin.cpp getURDF(): waits for the "
    "service of robot_param_node, by default robot_state_publisher, in the plugin's namespace (foxy to iron)",
    bad=[
        _files(),
        _files(_ELSEWHERE),
        _files(distro="humble"),
        _files(_ELSEWHERE, distro="humble"),
        _files(_RENAMED, distro="humble"),
    ],
    good=[
        _files(PUBLISHER, mark=_SOUND),
        _files(PUBLISHER, distro="humble", mark=_SOUND),
        _files(_RENAMED, mark=_SOUND),
        {**_files(mark=_SOUND), "state.launch.xml": f"<launch>{PUBLISHER}</launch>"},
    ],
)
def plugin_without_description(project: Project) -> Iterator[Finding]:
    """Controller manager in a simulator gets no robot description.

    The model itself may come from a file, but the controller manager of the simulator's plugin waits for the
    description: since jazzy for the topic robot_description in the plugin's namespace, until iron for a parameter of
    the node robot_state_publisher there. It waits for ever, gz with it, and no spawner gets an answer. If nothing here
    publishes a description, somebody may start that by hand: a warning.
    """
    launch = launch_of(project, ROS_2)
    if launch is None or not launch.complete or not any(one.sure for one in launch.simulations):
        return
    spawner = next((node for node in model_spawners(launch) if node.sure and node.complete), None)
    publishers = state_publishers(launch)
    if spawner is None or option_of(spawner, "robot_namespace") is not None:
        return
    if not all(node.namespace is not None and node.complete for node in publishers):
        return
    for plugin in control_plugins(project):
        namespace = _namespace(plugin)
        if namespace is not None:
            yield from _of_plugin(project, launch, plugin, namespace, publishers)


def _namespace(plugin: LoadedPlugin) -> str | None:
    """The namespace of a plugin that waits for the usual description; None if it is unknown, or if it may be renamed."""
    if plugin.library == "gazebo_ros_control" or plugin.simulator not in {"gz", "gazebo-classic"}:
        return None
    if any(plugin.setting(name) for name in ("ros/remapping", "robot_param", "robot_param_node")):
        return None
    given = plugin.setting("ros/namespace")
    if given is None:
        return ""
    return namespace_of(given.text) if is_known(given.text) else None


def _of_plugin(
    project: Project, launch: Launch, plugin: LoadedPlugin, namespace: str, publishers: list[Node]
) -> Iterator[Finding]:
    distros = set(project.distros)
    by_topic, by_node = distros <= set(since("jazzy")), distros <= set(until("iron"))
    if not publishers:
        if _is_from_topic(launch) or project.may_mention(PUBLISHES_DESCRIPTION):
            return
        message = (
            "the controller manager in the simulator waits for the robot description, which nothing here publishes"
        )
        yield Finding(plugin.plugin.at, f"{message}; start robot_state_publisher", severity=Severity.WARNING)
        return
    asked = f"{namespace}/robot_description" if by_topic else f"{namespace}/{_PUBLISHER}"
    offered = {description_topic(each) if by_topic else _full_name(each): each for each in publishers}
    if asked in offered or not (by_topic or by_node):
        return
    name, publisher = next(iter(offered.items()))
    what = f"robot_state_publisher publishes '{name}'" if by_topic else f"robot_state_publisher is '{name}'"
    message = f"the controller manager in the simulator waits for '{asked}', but {what}"
    sure = all(node.sure for node in launch.nodes)
    note = Note("robot_state_publisher is started here", publisher.at)
    yield Finding(plugin.plugin.at, message, (note,), severity=None if sure else Severity.WARNING)


def _is_from_topic(launch: Launch) -> bool:
    """Whether the model comes from a topic: another rule tells who does not publish that."""
    return any(option_of(node, "topic") is not None for node in model_spawners(launch))


def _full_name(node: Node) -> str:
    return f"{node.namespace or ''}/{node.name or _PUBLISHER}"
