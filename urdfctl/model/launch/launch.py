"""The model of a launch file: what it is known to do with a robot and its controllers, each fact with its place."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from itertools import chain
from typing import TYPE_CHECKING, Any

from urdfctl.model.launch.package import Package
from urdfctl.model.launch.parts import (
    WEBOTS,
    Description,
    GivenParameters,
    InlineParameters,
    LaunchedFile,
    Node,
    ParameterLoad,
    Simulation,
    Spawn,
    Waiting,
    Word,
    joined,
)
from urdfctl.model.launch.robot_homes import nearest_home, strays
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.model.controllers import FileReference
    from urdfctl.model.moveit import MoveItFiles

_WITHOUT_CONTROLLERS = frozenset({"moveit_ros_move_group", "moveit_servo", "teleop_twist_joy", "diagnostic_aggregator"})

_NOBODY: Mapping[str, Collection[str]] = {}
_DECIDING = ("ros2_control_node", None, "robot_state_publisher")
"""The nodes that decide which description is that of the robot, the parameter server of ROS 1 among them."""
_STARTED_TOGETHER = (
    *("descriptions", "loads", "spawns", "elsewhere", "nodes", "simulations", "references", "packages", "strays"),
    *("undeclared", "inline", "given", "misspelt", "moveit", "named", "misnamed", "skipped", "waiting", "slips"),
    *("absent", "variables"),
)
"""What launch files add to each other if they are started beside each other."""


class Launch(NamedTuple):
    """A launch file together with the files that it includes.

    ros: the ROS generation, 1 or 2.
    loads: the parameter files that are loaded.
    complete: False if some actions are unknown, e.g. because an included file cannot be read.
    elsewhere: spawners that run only with other launch arguments.
    packages: the packages that it names.
    package: the package that contains it; None if unknown.
    strays: ROS 1: arguments for included files that do not declare them.
    undeclared: names of arguments that are used for sure, and not declared: in the file (ROS 1), before it (ROS 2).
    arguments: the launch arguments that the file itself declares, with their defaults; None for a required one.
    choices: ROS 2: the values that it allows for these arguments.
    inline: ROS 1: the parameters that it contains.
    misspelt: the packages that it names and that do not exist, each with the package that was probably meant.
    moveit: the files that it gives to MoveIt.
    given: ROS 2: the parameters in dicts.
    others: the descriptions of its other robots, if only what belongs to one is kept.
    unread: the included files that cannot be read, if nothing else makes it incomplete.
    absent: the included files that cannot be read, whatever else is unknown.
    beside: the nodes of each of several launch files that are started beside each other.
    named: ROS 1: the full names of the parameters, and namespaces of parameters, that it sets.
    misnamed: ROS 1: the names of parameters that have a robot description, and are robot_description with a slip.
    skipped: the texts of the parts that run only with other launch arguments.
    waiting: ROS 2: what waits for an event that never comes.
    slips: arguments for included files that these need not declare, each with the one that was probably meant. In ROS 1
      only with `pass_all_args`.
    variables: the environment variables that it requires, and that are not given.
    """

    path: str
    ros: int
    descriptions: tuple[Description, ...] = ()
    loads: tuple[ParameterLoad, ...] = ()
    spawns: tuple[Spawn, ...] = ()
    complete: bool = True
    elsewhere: tuple[Spawn, ...] = ()
    nodes: tuple[Node, ...] = ()
    simulations: tuple[Simulation, ...] = ()
    references: tuple[LaunchedFile, ...] = ()
    packages: tuple[Word, ...] = ()
    package: Package | None = None
    strays: tuple[Word, ...] = ()
    undeclared: tuple[Word, ...] = ()
    arguments: tuple[tuple[str, str | None], ...] = ()
    choices: tuple[tuple[str, tuple[str, ...]], ...] = ()
    inline: tuple[InlineParameters, ...] = ()
    misspelt: tuple[tuple[Word, str], ...] = ()
    moveit: tuple[MoveItFiles, ...] = ()
    given: tuple[GivenParameters, ...] = ()
    others: tuple[Description, ...] = ()
    unread: tuple[Word, ...] = ()
    absent: tuple[Word, ...] = ()
    beside: tuple[tuple[Node, ...], ...] = ()
    named: tuple[str, ...] = ()
    misnamed: tuple[Word, ...] = ()
    skipped: tuple[str, ...] = ()
    waiting: tuple[Waiting, ...] = ()
    slips: tuple[tuple[Word, str], ...] = ()
    variables: tuple[str, ...] = ()

    @property
    def started(self) -> tuple[str, ...] | None:
        """The controllers that are started together, with their namespaces if known; None if some are unknown, or if
        there are no spawners."""
        if not self.complete or not self.spawns or not all(spawn.sure and spawn.complete for spawn in self.spawns):
            return None
        return tuple(dict.fromkeys(s.full_name(name) for s in self.spawns if s.active for name, _ in s.names))

    @property
    def is_leftover(self) -> bool:
        """Whether it is written for ROS 1, in a package that is built for ROS 2."""
        return self.ros == 1 and self.package is not None and self.package.ros not in (None, 1)

    @property
    def description(self) -> Description | None:
        """The robot description, if there is only one; of several robots, the first. None if it is not known."""
        robots = self.robots
        return robots[0] if robots else None

    @property
    def robots(self) -> tuple[Description, ...]:
        """The descriptions of all robots, each once, with the robot's namespace; empty if it is not known which.

        The same description in a namespace and below it is one robot, unless each has a controller manager. A node's
        own description belongs to the node's namespace, unless controllers are loaded under the node's name. Of
        different descriptions for one namespace, that of the controller manager counts, then that of
        robot_state_publisher, and if it does not exist, no other; in ROS 1 the one that is set last. Of several nodes
        of one kind that are all started, the first counts: they publish to one topic.
        """
        homed = [each._replace(namespace=self._home(each)) for each in self.descriptions]
        usable = [each for each in homed if each.usable and not (self.ros > 1 and _is_behind_lost(each, homed))]
        sure = [each for each in usable if each.sure]
        robots: list[Description] = []
        managed = {node.namespace for node in self.nodes if node.runs("controller_manager", "ros2_control_node")}
        if self.ros == 1:
            managed = {spawn.namespace for spawn in self.spawns if spawn.sure}
        for each in sorted(_decisive(sure or usable), key=lambda one: (one.namespace or "").count("/")):
            if not any(_is_same_robot(each, robot, managed) for robot in robots):
                robots.append(each)
        order = [each.at for each in self.descriptions]
        robots.sort(key=lambda one: order.index(one.at))
        first = {each.namespace: each for each in reversed(robots)}
        if len(first) < len(robots) and not sure:
            return ()  # different descriptions for one namespace
        return tuple(each for each in robots if first[each.namespace] is each)

    @property
    def namespaces_of_others(self) -> frozenset[str]:
        """The namespaces of its other robots, if only what belongs to one is kept."""
        return frozenset(other.namespace for other in self.others if other.namespace)

    @property
    def unfollowed(self) -> tuple[str, ...]:
        """The launch files that it includes and that are worth checking on their own.

        Those that it may or may not include; all of them if no robot is known. In ROS 1, `.launch.xml` is the ending of
        files that are only included.
        """
        robots = self.robots
        included = (one for one in self.references if one.use == "include" and one.file.exists)
        paths = (one.file.path for one in included if not (robots and one.sure))
        only_included = ".launch.xml" if self.ros == 1 else ()
        return tuple(dict.fromkeys(path for path in paths if path and not path.endswith(only_included)))

    @property
    def runs_without_simulator(self) -> bool:
        """Whether it is known to start a controller manager of ROS 2, and no simulator."""
        managers = (node for node in self.nodes if node.sure and node.runs("controller_manager", "ros2_control_node"))
        return self.complete and not self.simulations and any(managers)

    @property
    def runs_webots(self) -> bool:
        """Whether it certainly starts Webots, which has a description of the robot of its own."""
        return any(node.sure and node.runs(*WEBOTS) for node in self.nodes)

    def is_of_other_node(self, load: ParameterLoad) -> bool:
        """Return whether ROS 1 loads parameters under the name of a node that manages no controllers."""
        namespace = load.namespace
        if self.ros > 1 or not namespace or any(spawn.namespace == namespace for spawn in self.spawns):
            return False
        named = (
            node for node in self.nodes if node.sure and joined(node.namespace or "", node.name or "") == namespace
        )
        return any(node.package.text in _WITHOUT_CONTROLLERS for node in named)

    def among(self, robot: Description) -> Launch:
        """Return the launch file with only what belongs to one of its robots: what no other robot is nearer to."""
        others = {self._home(each) or "" for each in self.descriptions if not each.usable}
        robots = self.robots
        homes = others | {each.namespace or "" for each in robots}
        home = robot.namespace or ""

        if len(homes) < 2:  # noqa: PLR2004
            return self
        loading = [*(load.namespace for load in self.loads), *(one.namespace for one in self.inline)]
        spawning = [spawn.namespace for spawn in self.spawns]
        loaded_for = strays(loading, spawning, homes) if self.ros == 1 else {}
        spawned_for = strays(spawning, loading, homes) if self.ros == 1 else {}

        def belongs(namespace: str | None, meant: Mapping[str, Collection[str]] = _NOBODY) -> bool:
            if namespace is None or namespace in meant:
                return namespace is None or home in meant[namespace]
            return nearest_home(namespace, homes, home) == home

        return self._replace(
            descriptions=tuple(each for each in self.descriptions if belongs(self._home(each))),
            others=tuple(each for each in robots if each.namespace != robot.namespace),
            loads=tuple(
                load for load in self.loads if belongs(load.of if self.ros > 1 else load.namespace, loaded_for)
            ),
            spawns=tuple(spawn for spawn in self.spawns if belongs(spawn.namespace, spawned_for)),
            inline=tuple(one for one in self.inline if belongs(one.namespace, loaded_for)),
            given=tuple(one for one in self.given if belongs(one.of)),
        )

    def with_open_files(self, paths: Collection[str | None]) -> Launch:
        """Return the launch file, where it is not known whether some files exist."""

        def opened(file: FileReference) -> FileReference:
            return file._replace(exists=None) if file.path in paths else file

        return self._replace(
            references=tuple(one._replace(file=opened(one.file)) for one in self.references),
            descriptions=tuple(one._replace(file=opened(one.file)) for one in self.descriptions),
            loads=tuple(one._replace(file=opened(one.file)) for one in self.loads),
            moveit=tuple(one._replace(semantic=one.semantic and opened(one.semantic)) for one in self.moveit),
        )

    def with_beside(self, others: Sequence[Launch]) -> Launch:
        """Return the launch file with what others start beside it. Its arguments and its package stay its own."""
        every = (self, *others)
        lists: dict[str, Any] = {}
        for name in _STARTED_TOGETHER:
            lists[name] = tuple(chain.from_iterable(getattr(each, name) for each in every))
        followed = all(each.complete or each.unread for each in every)
        unread = tuple(word for each in every for word in each.unread) if followed else ()
        nodes = tuple(each.nodes for each in every)
        return self._replace(**lists, complete=all(each.complete for each in every), unread=unread, beside=nodes)

    def _home(self, description: Description) -> str | None:
        """The namespace of the robot that a description is of."""
        own = description.namespace
        if own is None or not description.in_node:
            return own
        used = {load.namespace for load in self.loads if not load.in_node} | {spawn.namespace for spawn in self.spawns}
        return own if own in used else own.rpartition("/")[0]


def _decisive(descriptions: Sequence[Description]) -> list[Description]:
    """The descriptions without those that a more important node of their namespace does not get.

    roslaunch sets parameters in the order of the files: the last one that is set stays (roslaunch, loader.py).
    """
    best: dict[str | None, int] = {}
    for each in descriptions:
        best[each.namespace] = min(best.get(each.namespace, len(_DECIDING)), _rank(each))
    last = {each.namespace: each for each in descriptions if each.node is None}
    kept = [each for each in descriptions if _rank(each) == best[each.namespace]]
    return [each for each in kept if each.node is not None or each is last[each.namespace]]


def _rank(description: Description) -> int:
    """How much a node decides which description is that of the robot; 0 is most."""
    return _DECIDING.index(description.node) if description.node in _DECIDING else len(_DECIDING)


def _is_behind_lost(description: Description, others: Sequence[Description]) -> bool:
    """Whether a more important node of the namespace certainly gets a description that does not exist."""
    lost = (each for each in others if each.sure and each.file.exists is False)
    return any(each.namespace == description.namespace and _rank(each) < _rank(description) for each in lost)


def _is_same_robot(description: Description, robot: Description, managed: Collection[str | None]) -> bool:
    """Whether a description is that of a robot nearer to the root.

    managed: the namespaces with a controller manager.
    """
    spaces = {description.namespace, robot.namespace}
    if len(spaces) > 1 and spaces <= set(managed):
        return False
    is_same = (description.file.path, description.arguments) == (robot.file.path, robot.arguments)
    return is_same and f"{description.namespace or ''}/".startswith(f"{robot.namespace or ''}/")
