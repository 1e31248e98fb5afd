"""What the rules look at: one robot in one variant, with what belongs to it."""

from __future__ import annotations

from collections.abc import Callable

from urdfctl.catalog.additions import NO_ADDITIONS, Additions
from urdfctl.catalog.distros import ALL
from urdfctl.hints import TYPE_CHECKING
from urdfctl.model.robot import Robot
from urdfctl.record import NamedTuple
from urdfctl.source.influence import Influence, no_influence
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place

if TYPE_CHECKING:
    from urdfctl.catalog.catalog import Catalog
    from urdfctl.model.controllers import Controllers
    from urdfctl.model.launch import Launch


class Project(NamedTuple):
    """One robot in one variant; a run has several.

    `distro` is None where neither the user nor the files tell it; `distros` are those that it may be. `started` are the
    controllers started together, None where nothing tells; `in_order` where their order is known. `complete` is False
    where a part of the robot could not be expanded: then nothing may be claimed to be absent. In a macro `library` what
    conditions guard stands side by side: then nothing may be claimed to be there twice. `controllers` is None where no
    controllers' file belongs to the robot; a controllers' file without a robot is a project too. `launch` is the launch
    file that told which belong together. `simulator_from` tells what named the simulator, `influence` what the values
    at a place hang on. `listed` are the joints that the package lists for drivers of industrial robots.
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
    in_order: bool = False
    listed: tuple[tuple[str, Place], ...] = ()

    @property
    def ros(self) -> int | None:
        """1 or 2, None where not known."""
        from urdfctl.catalog.distros import generation

        generations = {generation(distro) for distro in self.distros}
        return generations.pop() if len(generations) == 1 else None

    @property
    def catalog(self) -> Catalog:
        """What the world offers, with what the user adds; read when it is first asked for."""
        from urdfctl.catalog.catalog import catalog_with

        return catalog_with(self.additions)

    @property
    def may_be_simulated(self) -> bool:
        """Whether Gazebo may run it: not known to run on real hardware alone."""
        return self.simulator != "none"

    @property
    def named_simulator(self) -> str | None:
        """The simulator that the user names; None where only a plugin does: such a robot may be real all the same."""
        return None if (self.simulator_from or "").startswith("the plugin ") else self.simulator

    def of_kind(self, kind: ProblemKind) -> tuple[Problem, ...]:
        """The problems of a kind that reading met."""
        return tuple(problem for problem in self.problems if problem.kind is kind)
