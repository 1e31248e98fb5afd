"""What can be said of a robot before anything moves: how far each controller gets, and what physics tells without an
engine."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint import Outcome
from urdfctl.load import Seen
from urdfctl.model.project import Project
from urdfctl.record import NamedTuple
from urdfctl.rules import rule_of
from urdfctl.smoke.anchors import anchors_of, diagnostics_of, silenced
from urdfctl.smoke.manager import Cycle, life_cycle
from urdfctl.smoke.mechanism import Mechanism, mechanism_of
from urdfctl.smoke.results import ControllerResult, Smoked, Step, Trouble, Verdict
from urdfctl.smoke.stability import loop_troubles
from urdfctl.smoke.statics import static_troubles
from urdfctl.smoke.tasks import Task, task_of

RATES = {1: 1000.0, 2: 100.0}
"""How often a manager updates its controllers, in Hz, where nothing is said: gazebo_ros_control at each step of 1 ms,
the controller manager of ROS 2 by its own default."""
_OURS = "UC000"


class Judgement(NamedTuple):
    """A robot with what its controllers are to move (no mechanism where it is not to be moved), how often they are
    updated, in Hz, and what is wrong so far."""

    seen: Seen
    cycle: Cycle
    mechanism: Mechanism | None
    tasks: tuple[Task, ...]
    rate: float
    troubles: tuple[Trouble, ...]
    only: tuple[str, ...] = ()

    def wants(self, name: str | None) -> bool:
        """Whether a controller was asked for; what is of no controller is always told."""
        return name is None or not self.only or name in self.only

    @property
    def results(self) -> tuple[ControllerResult, ...]:
        """The verdicts as far as they are known."""
        made = (way.result for way in self.cycle.ways if self.wants(way.configured.name))
        return tuple(changed(result, self.troubles) for result in made)

    def anchors(self) -> dict[str, Diagnostic]:
        """Where each thing that may be told of stands."""
        return anchors_of(self.seen.project, self.seen.linted.outcome.diagnostics)

    def silenced(self) -> dict[str, list[str]]:
        """The codes that comments silence, by what they are about."""
        return silenced(self.seen.project, list(self.seen.sources.values()))

    @property
    def smoked(self) -> Smoked:
        """The smoke test, as far as it is known."""
        linted = self.seen.linted
        found = linted.outcome.diagnostics
        told = [one for one in self.troubles if self.wants(one.controller)]
        anchors = anchors_of(self.seen.project, found, {one.subject for one in told})
        diagnostics = list(diagnostics_of(told, anchors, self.silenced()))
        outcome = Outcome([*(one for one in found if one.code == _OURS), *diagnostics], [], linted.outcome.crashed)
        return Smoked(linted._replace(outcome=outcome, distro=self.cycle.distro), self.results)


def judged(seen: Seen, only: Sequence[str] = ()) -> Judgement:
    """What can be said of a robot that was linted; of all its controllers, or those of some names."""
    project = seen.project
    cycle = life_cycle(project, seen.linted.outcome.diagnostics)
    rate = _rate(project, cycle.ros)
    robot = project.robot if cycle.spawned and project.complete and not project.library else None
    mechanism = mechanism_of(robot) if robot else None
    tasks = tuple(task_of(way.configured) for way in cycle.ways if not way.refusal)
    troubles = list(cycle.troubles)
    if robot and robot.links and mechanism is None:
        why = "its links are no tree that hangs on one root: each link but the root is the child of one joint"
        troubles.append(Trouble("UC901", "robot", f"the robot cannot be spawned: {why}"))
    if mechanism is not None:
        troubles += static_troubles(mechanism, tasks)
        troubles += loop_troubles(mechanism, tasks, rate)
    return Judgement(seen, cycle, mechanism, tasks, rate, tuple(troubles), tuple(only))


def _rate(project: Project, ros: int) -> float:
    managers = project.controllers.managers if project.controllers else ()
    values = (manager.parameters.value("update_rate") for manager in managers)
    given = next((one.value for one in values if one is not None), None)
    return float(given) if isinstance(given, int | float) and given > 0 else RATES[ros]


def changed(result: ControllerResult, troubles: Iterable[Trouble]) -> ControllerResult:
    """A verdict with what was found of its controller: an error makes it fail at moving, a warning makes it warned."""
    mine = [one for one in troubles if one.controller == result.name]
    errors = [one for one in mine if rule_of(one.code).severity is Severity.ERROR]
    if result.verdict is Verdict.FAILED or not mine:
        return result
    if errors:
        return result._replace(verdict=Verdict.FAILED, stage=Step.MOVE, reason=errors[0].message)
    return result._replace(verdict=Verdict.WARNED, reason=mine[0].message)
