"""The model of MoveIt's configuration of a robot: its SRDF, and its YAML files."""

from __future__ import annotations

from urdfctl.model.controllers import Key, MoveItController
from urdfctl.model.moveit_files import MoveItFiles
from urdfctl.model.semantic import Semantic
from urdfctl.source.span import Place
from urdfctl.source.yaml import Mapping, Node, Scalar
from urdfctl.startup.records import NamedTuple


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
    unlisted: the sections of controllers that `controller_names` does not list.
    guessed: whether the arguments of the launch file are guessed, so that the files may be for another robot.
    """

    files: MoveItFiles | None = None
    semantic: Semantic | None = None
    solvers: tuple[Solver, ...] = ()
    limits: tuple[JointLimits, ...] = ()
    controllers: tuple[MoveItController, ...] = ()
    pipelines: tuple[Pipeline, ...] = ()
    empty: tuple[tuple[str, Place], ...] = ()
    no_controllers: Place | None = None
    unlisted: tuple[Key, ...] = ()
    guessed: bool = False
