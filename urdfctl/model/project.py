"""The input of the rules: one robot in one variant, with everything that belongs to it."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Protocol

from urdfctl.catalog.additions import NO_ADDITIONS, Additions
from urdfctl.catalog.distros import ALL, generation
from urdfctl.model.robot import Robot
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place
from urdfctl.source.xacro.influence import Influence, no_influence, no_origin
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.catalog.catalog import Catalog
    from urdfctl.model.controllers import Controllers
    from urdfctl.model.launch import Launch
    from urdfctl.model.moveit import MoveIt


class EvidenceItem(NamedTuple):
    """A fact that speaks for some distros.

    kind: where it is from; of several items of a kind, the heaviest counts.
    what: the fact, in words.
    distros: the distros that it speaks for.
    weight: how much it says about the generation, from 1 to EXPLICIT.
    file: the file that says it; None for the robot itself.
    """

    kind: str
    what: str
    distros: tuple[str, ...]
    weight: int
    file: str | None = None

    @property
    def ros(self) -> int | None:
        """The generation that it speaks for, 1 or 2; None if for both."""
        generations = {generation(distro) for distro in self.distros}
        return generations.pop() if len(generations) == 1 else None


class Evidence(NamedTuple):
    """The distro and the simulator of a robot, and what indicates them.

    distro: the distro; None if several are possible.
    distros: the possible distros.
    source: what says most for them; None if nothing does.
    items: everything that indicates a distro, also what was outweighed.
    """

    distro: str | None
    distros: tuple[str, ...]
    source: str | None
    simulator: str | None = None
    simulator_from: str | None = None
    items: tuple[EvidenceItem, ...] = ()

    @property
    def ros(self) -> int | None:
        """1 or 2; None if unknown."""
        generations = {generation(distro) for distro in self.distros}
        return generations.pop() if len(generations) == 1 else None


class OwnHardware(NamedTuple):
    """How a package of the workspace makes a hardware class known to pluginlib.

    kind: the C++ class, as the plugin description says it.
    base: the C++ class that it is loaded as.
    description: the plugin description, by its path in the package.
    category: what the build file exports that description for; empty if for nothing, None if unknown.
    built: the classes that the sources export, each with its base.
    """

    package: str
    kind: str
    base: str
    description: str
    category: str | None = None
    built: tuple[tuple[str, str], ...] = ()


class OwnTypes(NamedTuple):
    """Types that packages of the workspace export, as far as the project concerns them.

    controllers: entries of controllers in the form of the catalogue, by type. `open`: the controller may read other
        parameters too; if it has no `parameters`, they are unknown.
    hardware: the names of hardware plugins.
    classes: the classes of those that the project uses, by name.
    nodes: the parameters of other nodes, by the node's name.
    """

    controllers: Mapping[str, Mapping[str, Any]] = MappingProxyType({})
    hardware: tuple[str, ...] = ()
    classes: Mapping[str, OwnHardware] = MappingProxyType({})
    nodes: Mapping[str, Mapping[str, Mapping[str, Any]]] = MappingProxyType({})


NO_OWN_TYPES = OwnTypes()


class Mentioned(Protocol):
    """What tells whether another text of the workspace says what an expression matches."""

    def __call__(self, expression: str, apart: str = "", /, *, of_builds: bool = False) -> bool | None:
        """Return whether one does, see `Project.may_mention`; None if unknown.

        of_builds: look only at texts that say how the workspace is made: lists of repositories, READMEs, scripts.
        """


def mentions_unknown(_expression: str, _apart: str = "", /, *, of_builds: bool = False) -> bool | None:  # noqa: ARG001
    """Return None: nobody looked at what other files say."""
    return None


class BuildFaults(NamedTuple):
    """What is wrong in CMakeLists.txt of the packages.

    absent: the files and folders that are installed and do not exist.
    unregistered: the packages of ament that never call ament_package(), each with the call that names its project.
    """

    absent: tuple[tuple[str, Place], ...] = ()
    unregistered: tuple[tuple[str, Place], ...] = ()


class Project(NamedTuple):
    """One robot in one variant. A run has several projects.

    robot: None for controller files without a robot.
    path: the file that was linted.
    distro: the ROS distro; None if neither the user nor the files name one.
    distros: the distros that are possible.
    distro_from: what named the distro.
    simulator: the simulator; `none` for real hardware only, None if unknown.
    started: the controllers that are started together; None if unknown.
    problems: the problems in reading the files.
    complete: False if part of the robot could not be expanded. Then no rule may report that something is missing.
    library: True for a macro library, in which the branches of all conditions are expanded side by side. Then no rule
        may report duplicates.
    controllers: None if the robot has no controller files.
    additions: the user's additions to the catalogue.
    launch: the launch file that combines the robot and its controllers.
    simulator_from: what named the simulator.
    influence: returns the YAML files and the arguments that the values at a place depend on.
    origin: returns where a value is written that a place takes over from a property or the call of a macro.
    in_order: whether the order of `started` is known.
    listed: the joints that the package lists for drivers of industrial robots.
    together: whether robot and controller files belong together because they are named together, or nothing else is
        there.
    evidence: everything that indicates the distro; None if nobody looked.
    own: the types that packages of the workspace define themselves, if the catalogue does not have some type.
    build: what is wrong in CMakeLists.txt of the packages.
    moveit: MoveIt's configuration of the robot; None if there is none.
    todos: what a migration left to a person in the files that were read, with the place of the comment.
    mentioned: returns whether a text of the workspace that was not read, such as another launch file, a script or a
        README, says what a regular expression matches; None if that is not known.
    """

    robot: Robot | None
    path: str = ""
    distro: str | None = None
    distros: tuple[str, ...] = ALL
    distro_from: str | None = None
    simulator: str | None = None
    started: tuple[str, ...] | None = None
    problems: tuple[Problem, ...] = ()
    complete: bool = True
    library: bool = False
    controllers: Controllers | None = None
    additions: Additions = NO_ADDITIONS
    launch: Launch | None = None
    simulator_from: str | None = None
    influence: Callable[[Place], Influence] = no_influence
    origin: Callable[[Place], Place] = no_origin
    in_order: bool = False
    listed: tuple[tuple[str, Place], ...] = ()
    together: bool = False
    evidence: Evidence | None = None
    own: OwnTypes = NO_OWN_TYPES
    build: BuildFaults = BuildFaults()
    moveit: MoveIt | None = None
    todos: tuple[tuple[str, Place], ...] = ()
    mentioned: Mentioned = mentions_unknown

    @property
    def ros(self) -> int | None:
        """The ROS generation, 1 or 2; None if unknown."""
        generations = {generation(distro) for distro in self.distros}
        return generations.pop() if len(generations) == 1 else None

    def may_mention(self, expression: str, apart: str = "") -> bool:
        """Return whether another text of the workspace says what an expression matches, unless it is known not to.

        A part of the launch file that runs only with other arguments counts as another text.

        apart: what launch files say that do not count: they are not started beside this one.
        """
        skipped = self.launch.skipped if self.launch else ()
        return any(re.search(expression, text) for text in skipped) or self.mentioned(expression, apart) is not False

    @property
    def catalog(self) -> Catalog:
        """The catalogue with the user's additions, loaded on first use."""
        from urdfctl.catalog.catalog import catalog_with

        return catalog_with(self.additions)

    @property
    def may_be_simulated(self) -> bool:
        """Whether it may run in a simulator: it is not known to run on real hardware only."""
        return self.simulator != "none"

    @property
    def named_simulator(self) -> str | None:
        """The simulator, unless only a plugin names it: such a robot may also run on real hardware."""
        return None if (self.simulator_from or "").startswith("the plugin ") else self.simulator

    def of_kind(self, kind: ProblemKind) -> tuple[Problem, ...]:
        """Return the problems of one kind."""
        return tuple(problem for problem in self.problems if problem.kind is kind)
