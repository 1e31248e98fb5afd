"""Helpers for the rules on launch files: which nodes, controller managers and spawners are started."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import control_plugins, namespace_of
from urdfctl.control.hosts import CONTROLLER_MANAGER, MANAGER, state_publisher
from urdfctl.model.launch import Launch, Node, Spawn
from urdfctl.rule import Project
from urdfctl.rules.common import is_known, robot_in
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

ROS_2 = 2
_OF_WEBOTS = "webots_ros2_control::Ros2Control"
_CLOCKS = re.compile(r"clock|sim|gazebo|gz|mujoco|webots|isaac|unity|bag|(?<!dis)play")
"""In the name of a program that may publish the time."""


class Running(NamedTuple):
    """A running controller manager, started by a node or by a plugin of the robot in a simulator."""

    namespace: str | None
    """None if it is unknown."""
    name: str | None
    """None if it is unknown."""
    at: Place
    """The node or plugin that starts it."""
    node: Node | None = None
    """The node that starts it, None for a plugin."""

    @property
    def full_name(self) -> str:
        """The name with its namespace, e.g. `/left/controller_manager`."""
        return f"{self.namespace or ''}/{self.name}"


def launch_of(project: Project, ros: int) -> Launch | None:
    """Return the project's launch file if it is for this generation of ROS, 1 or 2."""
    launch = project.launch
    return launch if launch is not None and launch.ros == ros else None


def spawners(launch: Launch) -> tuple[Spawn, ...]:
    """Return all spawners of a launch file, including those that run only with other arguments."""
    return (*launch.spawns, *launch.elsewhere)


def manager_nodes(launch: Launch) -> tuple[Node, ...]:
    """Return the nodes that are controller managers of ROS 2."""
    return tuple(node for node in launch.nodes if node.runs(CONTROLLER_MANAGER, MANAGER))


def simulators_managers(project: Project) -> Iterator[Running]:
    """Yield the controller managers that plugins of the robot start in a simulator of ROS 2."""
    for control_plugin in control_plugins(project):
        if control_plugin.library == "gazebo_ros_control":
            continue
        namespace = control_plugin.setting("ros/namespace")
        name = control_plugin.setting("controller_manager_name")
        texts = [tag.text for tag in (namespace, name) if tag]
        known = is_known(*texts)
        yield Running(
            namespace_of(namespace.text if namespace else "") if known else None,
            (name.text.strip() if name else CONTROLLER_MANAGER) if known else None,
            control_plugin.plugin.at,
        )


def webots_managers(project: Project, launch: Launch) -> Iterator[Running]:
    """Yield the controller managers that Webots' driver starts with its plugin in the description.

    webots_ros2_control Ros2Control.cpp init(): their name is always `controller_manager`.
    """
    robot = robot_in(project)
    of_webots = [tag for tag in robot.others if tag.name == "webots"] if robot else []
    types = [plugin.attributes.get("type") for tag in of_webots for plugin in tag.named("plugin")]
    for node in launch.nodes if _OF_WEBOTS in types else ():
        if node.runs("webots_ros2_driver", "driver"):
            yield Running(node.namespace, CONTROLLER_MANAGER, node.at, node)


def managers(project: Project, launch: Launch) -> tuple[Running, ...]:
    """Return the running controller managers of ROS 2.

    The plugin of a simulator is in the description also where the launch file starts none.
    """
    nodes = (Running(node.namespace, node.name or CONTROLLER_MANAGER, node.at, node) for node in manager_nodes(launch))
    simulated = () if launch.runs_without_simulator else simulators_managers(project)
    return (*nodes, *simulated, *webots_managers(project, launch))


def is_sure(launch: Launch) -> bool:
    """Return whether everything that the launch file starts is known and always started."""
    return launch.complete and all(spawn.sure and spawn.complete for spawn in launch.spawns)


def is_spawner(spawn: Spawn) -> bool:
    """Return whether controllers are loaded by the spawner program, not by a command."""
    return spawn.program is not None and spawn.program.text in {"spawner", "spawner.py"}


def full_name(name: str, spawn: Spawn) -> str:
    """Return a spawned controller's name with its namespace and its manager's name."""
    return f"{spawn.namespace}/{spawn.manager}: {name}"


def state_publishers(launch: Launch) -> list[Node]:
    """Return the nodes that publish the robot's transforms and description."""
    return [node for node in launch.nodes if state_publisher(node)]


def may_publish_time(node: Node) -> bool:
    """Return whether the names of a node, or a file that it gets, are like those of a program that publishes /clock."""
    words = (node.package, node.executable, *node.words)
    return any(_CLOCKS.search(word.text.rpartition("/")[2]) for word in words)


def publishers_of_states(launch: Launch) -> list[Node]:
    """Return the nodes of joint_state_publisher."""
    return [node for node in launch.nodes if node.executable.text.startswith("joint_state_publisher")]
