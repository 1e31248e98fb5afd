"""What the rules on launch files share: what is surely started, and by which programs."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.launch import Launch, Node, Spawn
from urdfctl.record import NamedTuple
from urdfctl.rule import Project
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import control_plugins, namespace_of
from urdfctl.source.span import Place

ROS_2 = 2
MANAGER = "ros2_control_node"
CONTROLLER_MANAGER = "controller_manager"


class Running(NamedTuple):
    """A controller manager that runs: its namespace (None where it is not known) and name, and what starts it: a node,
    or a plugin of the robot in a simulator."""

    namespace: str | None
    name: str | None
    at: Place
    node: Node | None = None

    @property
    def full_name(self) -> str:
        """The name with its namespace."""
        return f"{self.namespace or ''}/{self.name}"


def launch_of(project: Project, ros: int) -> Launch | None:
    """The launch file, where it is of a generation of ROS."""
    launch = project.launch
    return launch if launch is not None and launch.ros == ros else None


def spawners(launch: Launch) -> tuple[Spawn, ...]:
    """The spawners of a launch file, those that run only with other arguments too."""
    return (*launch.spawns, *launch.elsewhere)


def manager_nodes(launch: Launch) -> tuple[Node, ...]:
    """The nodes that are controller managers of ROS 2."""
    return tuple(node for node in launch.nodes if node.runs(CONTROLLER_MANAGER, MANAGER))


def simulators_managers(project: Project) -> Iterator[Running]:
    """The controller managers that plugins of the robot bring into a simulator of ROS 2."""
    for one in control_plugins(project):
        if one.library == "gazebo_ros_control":
            continue
        namespace, name = one.setting("ros/namespace"), one.setting("controller_manager_name")
        texts = [tag.text for tag in (namespace, name) if tag]
        known = is_known(*texts)
        yield Running(
            namespace_of(namespace.text if namespace else "") if known else None,
            (name.text.strip() if name else CONTROLLER_MANAGER) if known else None,
            one.plugin.at,
        )


def managers(project: Project, launch: Launch) -> tuple[Running, ...]:
    """The controller managers of ROS 2 that run."""
    nodes = (Running(node.namespace, node.name or CONTROLLER_MANAGER, node.at, node) for node in manager_nodes(launch))
    return (*nodes, *simulators_managers(project))


def is_sure(launch: Launch) -> bool:
    """Whether all that the launch file starts is known, and surely started."""
    return launch.complete and all(spawn.sure and spawn.complete for spawn in launch.spawns)


def is_spawner(spawn: Spawn) -> bool:
    """Whether a spawner loads controllers, and no command."""
    return spawn.program is not None and spawn.program.text in {"spawner", "spawner.py"}


def full_name(name: str, spawn: Spawn) -> str:
    """A spawned controller's name with its namespace and its manager's name."""
    return f"{spawn.namespace}/{spawn.manager}: {name}"


def state_publishers(launch: Launch) -> list[Node]:
    """The nodes that publish the robot's transforms and description."""
    return [node for node in launch.nodes if node.runs("robot_state_publisher", *_OF_TRANSFORMS)]


_OF_TRANSFORMS = ("robot_state_publisher", "state_publisher")


def publishers_of_states(launch: Launch) -> list[Node]:
    """The nodes that publish states of joints by themselves."""
    return [node for node in launch.nodes if node.executable.text.startswith("joint_state_publisher")]


_NO_MANAGERS = frozenset(
    "robot_state_publisher joint_state_publisher joint_state_publisher_gui controller_manager rviz2 tf2_ros xacro "
    "rqt_joint_trajectory_controller rqt_gui topic_tools ros_gz_bridge ros_ign_bridge ros_gz_sim ros_ign_gazebo "
    "gazebo_ros nav2_util ros_gz_image twist_mux joy teleop_twist_joy rqt_robot_steering slam_toolbox "
    "robot_localization".split()
)


def hosts_no_manager(node: Node) -> bool:
    """Whether a node is surely no controller manager: of drivers of hardware nobody knows."""
    return node.package.text in _NO_MANAGERS and not node.runs(CONTROLLER_MANAGER, MANAGER)
