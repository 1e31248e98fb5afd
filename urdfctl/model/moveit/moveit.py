"""The model of MoveIt's configuration of a robot: the files that it gets, and what they say."""

from __future__ import annotations

from urdfctl.model.controllers import FileReference, Key, MoveItController
from urdfctl.model.robot import Tag
from urdfctl.source.problem import Problem
from urdfctl.source.span import Place
from urdfctl.source.yaml.tree import Mapping, Node, Scalar
from urdfctl.startup.records import NamedTuple


class MoveItFiles(NamedTuple):
    """The files that a launch file gives to MoveIt. None where it gives none, or an unknown one.

    at: the place in the launch file.
    semantic: the SRDF. arguments: the xacro arguments for it.
    kinematics: kinematics.yaml. limits: joint_limits.yaml.
    controllers: moveit_controllers.yaml, or in ROS 1 the files with a `controller_list`.
    pipelines: the names of planning pipelines, with their files.
    namespace: the namespace of the node that reads them; None if unknown.
    as_values: ROS 2: whether the launch file reads the YAML files and passes their content as values.
    runs: whether move_group is started with them.
    as_yaml: ROS 2: whether launch parses the text of the SRDF as YAML, because nothing says that it is a string.
    undecided: ROS 2: the files with controllers of which the builder can choose none; empty if it finds none, None if
        it reads one, or that is unknown.
    bare_kinematics: ROS 2: whether the groups in kinematics.yaml are passed without `robot_description_kinematics`.
    """

    at: Place
    semantic: FileReference | None = None
    arguments: tuple[tuple[str, str], ...] | None = ()
    kinematics: FileReference | None = None
    limits: FileReference | None = None
    controllers: tuple[FileReference, ...] = ()
    pipelines: tuple[tuple[str, FileReference], ...] = ()
    namespace: str | None = None
    sure: bool = True
    as_values: bool = False
    runs: bool = False
    as_yaml: bool = False
    bare_kinematics: bool = False
    undecided: tuple[str, ...] | None = None


class Chain(NamedTuple):
    """A `<chain>` of a group: the joints between two links. A missing name is None."""

    base: Key | None
    tip: Key | None
    at: Place


class Group(NamedTuple):
    """A planning group.

    links, joints: those that it lists.
    groups: the names of the groups that it contains.
    """

    name: Key
    links: tuple[Key, ...] = ()
    joints: tuple[Key, ...] = ()
    chains: tuple[Chain, ...] = ()
    groups: tuple[Key, ...] = ()

    @property
    def is_empty(self) -> bool:
        """Whether it lists nothing."""
        return not (self.links or self.joints or self.chains or self.groups)


class GroupState(NamedTuple):
    """A named state of a group, with its joints."""

    name: str
    group: Key | None
    joints: tuple[Key, ...]


class EndEffector(NamedTuple):
    """An end effector: its group, the link that it is attached to, and the group of that link."""

    name: str
    group: Key | None
    parent_link: Key | None
    parent_group: Key | None


class VirtualJoint(NamedTuple):
    """A joint between the robot and the world.

    name: None if missing.
    child: the link of the robot that it moves.
    type: `fixed`, `planar` or `floating`.
    """

    name: Key | None
    child: Key | None
    type: str


class Semantic(NamedTuple):
    """An SRDF file.

    name: the robot's name; None if missing.
    at: the root element.
    pairs: the links of each `<disable_collisions>`.
    passive: the joints that no controller moves.
    complete: False if part of it could not be expanded.
    tag: the root element.
    """

    path: str
    name: Key | None
    at: Place
    groups: tuple[Group, ...] = ()
    states: tuple[GroupState, ...] = ()
    effectors: tuple[EndEffector, ...] = ()
    virtual: tuple[VirtualJoint, ...] = ()
    pairs: tuple[tuple[Key, Key], ...] = ()
    passive: tuple[Key, ...] = ()
    complete: bool = True
    tag: Tag | None = None

    def group(self, name: str) -> Group | None:
        """Return the first group with a name, if any."""
        return next((group for group in self.groups if group.name.text == name), None)


class Solver(NamedTuple):
    """The kinematics solver of a group in kinematics.yaml; `solver` is None if not given."""

    group: Key
    solver: Key | None


class JointLimits(NamedTuple):
    """The limits of a joint in joint_limits.yaml, by name."""

    joint: Key
    values: tuple[tuple[Key, Scalar], ...]

    def value(self, name: str) -> Scalar | None:
        """Return the value of a setting, if it is given."""
        return next((value for key, value in self.values if key.text == name), None)


class Pipeline(NamedTuple):
    """A planning pipeline, such as ompl, and its settings."""

    name: str
    settings: Mapping

    def setting(self, name: str) -> tuple[Key, Node] | None:
        """Return the key and the value of a setting, if it is given."""
        entries = (entry for entry in self.settings.entries if entry.key.text == name)
        return next(((Key(entry.key.text, entry.key.at), entry.value) for entry in entries), None)


class MoveIt(NamedTuple):
    """MoveIt's configuration of a robot.

    files: the files that a launch file gives to MoveIt; None if they were found beside other files.
    semantic: the SRDF; None if it is unknown.
    solvers: the groups in kinematics.yaml.
    limits: the joints in joint_limits.yaml.
    controllers: the controllers that MoveIt sends trajectories to.
    empty: empty lists and missing values in the YAML files, with their keys.
    no_controllers: an empty list of controllers.
    plugin: the key, which may be misspelt, and the value of `moveit_controller_manager`.
    unlisted: the sections of controllers that `controller_names` does not list.
    problems: why the files are rejected.
    guessed: whether the arguments of the launch file are guessed, so that the files may be for another robot.
    is_here: whether MoveIt itself is in the workspace, and reads pipelines: it need not be the one of the distro.
    """

    files: MoveItFiles | None = None
    semantic: Semantic | None = None
    solvers: tuple[Solver, ...] = ()
    limits: tuple[JointLimits, ...] = ()
    controllers: tuple[MoveItController, ...] = ()
    pipelines: tuple[Pipeline, ...] = ()
    empty: tuple[tuple[str, Place], ...] = ()
    no_controllers: Place | None = None
    plugin: tuple[Key, Key] | None = None
    unlisted: tuple[Key, ...] = ()
    problems: tuple[Problem, ...] = ()
    guessed: bool = False
    is_here: bool = False
