"""The judgement on a robot before anything moves: how far each controller gets, and what needs no physics engine."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.results import Outcome
from urdfctl.lint.target import LintedTarget
from urdfctl.model.project import Project
from urdfctl.model.stage import Stage
from urdfctl.rules import rule_of
from urdfctl.rules.reading.rule_crashed import rule_crashed
from urdfctl.rules.smoke.loose_robot_tips_over import loose_robot_tips_over
from urdfctl.rules.smoke.robot_not_spawned import robot_not_spawned
from urdfctl.rules.smoke.verdict_depends_on_distro import verdict_depends_on_distro
from urdfctl.smoke.anchors import anchors_of, diagnostics_of, silenced, subjects
from urdfctl.smoke.assignments import TaskFile
from urdfctl.smoke.blame import place_of
from urdfctl.smoke.candidates import cycle_of, result_of
from urdfctl.smoke.gears import gear_troubles, gears_of, with_gears
from urdfctl.smoke.hardware import within_ranges
from urdfctl.smoke.manager import NOT_MOVED, Cycle
from urdfctl.smoke.mechanism import Mechanism, mechanism_of
from urdfctl.smoke.overlaps import overlap_troubles
from urdfctl.smoke.plain import with_plain_drives
from urdfctl.smoke.reading import tasks_of
from urdfctl.smoke.results import ROBOT, ControllerResult, Smoked, Trouble, Verdict, trouble_of
from urdfctl.smoke.shapes import Shapes, shapes_of, with_rims
from urdfctl.smoke.simulated import in_simulation
from urdfctl.smoke.spare import lenient, spare_controllers
from urdfctl.smoke.stability import loop_troubles
from urdfctl.smoke.statics import static_troubles
from urdfctl.smoke.support import Support, support_of
from urdfctl.smoke.tasks import Task
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

UNKNOWN_ROBOT = "not simulated: the robot is not known, or some of its parts are not"
"""Why a controller does not move if no engine can move it."""
RATES = {1: 1000.0, 2: 100.0}
"""The default update rate by generation of ROS, in Hz: gazebo_ros_control updates at each step of 1 ms, the controller
manager of ROS 2 at its own default."""


class Judgement(NamedTuple):
    """A robot with what its controllers should move, and what is wrong so far.

    `mechanism` is None if the robot cannot be simulated. `rate` is the update rate of the controllers, in Hz. `only`
    holds the names of the controllers that were asked for, none for all. `part_of` is the link of another file that
    the description hangs on: it is not a robot then. `given` holds the user's tasks. `support` is what
    a robot rests on that nothing fixes to the world.
    """

    seen: LintedTarget
    cycle: Cycle
    mechanism: Mechanism | None
    tasks: tuple[Task, ...]
    rate: float
    troubles: tuple[Trouble, ...]
    only: tuple[str, ...] = ()
    part_of: str = ""
    given: TaskFile | None = None
    support: Support = Support()

    def wants(self, name: str | None) -> bool:
        """Return whether a controller was asked for. Findings of no controller are always reported."""
        return name is None or not self.only or not {name, name.rpartition("/")[2]}.isdisjoint(self.only)

    @property
    def results(self) -> tuple[ControllerResult, ...]:
        """The results of the controllers, as far as they are known."""
        results = (result_of(way) for way in self.cycle.ways if self.wants(way.name))
        unknown = UNKNOWN_ROBOT if self.mechanism is None else NOT_MOVED
        known = (each._replace(reason=unknown) if each.reason == NOT_MOVED else each for each in results)
        results = (changed(result, self.troubles) for result in known)
        return tuple(lenient(result) if result.name in self.spare else result for result in results)

    @property
    def spare(self) -> dict[str, str]:
        """The controllers that are most likely not started, each with the reason; none if the user asks for some."""
        return {} if self.only else spare_controllers(self.seen.project, self.cycle, self.troubles)

    @property
    def _places(self) -> list[tuple[str, Place]]:
        """The place of everything that a finding can be about."""
        project = self.seen.project
        places = {way.name: place_of(way.configured.controller, project) for way in self.cycle.ways}
        of_tasks = [(each.subject, self.given.place_of(each)) for each in self.given.assignments] if self.given else []
        return of_tasks + list(subjects(project, {name: place for name, place in places.items() if place is not None}))

    def anchors(self) -> dict[str, Diagnostic]:
        """Return the place of everything that a finding of an engine can be about."""
        return anchors_of(self._places)

    def silenced(self) -> dict[str, list[str]]:
        """Return the codes that comments suppress, by subject."""
        return silenced(self._places, self.cycle.causes, list(self.seen.sources.values()))

    @property
    def smoked(self) -> Smoked:
        """The smoke test, as far as it is known."""
        linted = self.seen.result
        of_lint = linted.outcome.diagnostics
        troubles = [trouble for trouble in self.troubles if self.wants(trouble.controller)]
        anchors = {**self.cycle.causes, **anchors_of(self._places, {trouble.subject for trouble in troubles})}
        diagnostics = list(diagnostics_of(troubles, anchors, self.silenced(), self.spare))
        crashes = [finding for finding in of_lint if finding.code == rule_crashed.code]
        outcome = Outcome([*crashes, *diagnostics], [], linted.outcome.crashed)
        return Smoked(linted._replace(outcome=outcome), self.results, self.cycle.distro, part_of=self.part_of)


def judged(
    seen: LintedTarget,
    only: Sequence[str] = (),
    find_mesh: Callable[[str], str | None] | None = None,
    given: TaskFile | None = None,
) -> Judgement:
    """Return the judgement on a linted robot; on all its controllers, or on those with some names.

    `find_mesh` returns the path of a mesh, or None; without it the meshes are unknown. `given` holds the user's tasks.
    """
    project = seen.project
    cycle = cycle_of(seen)
    rate = _rate(project, cycle.ros)
    robot = project.robot if cycle.spawned and project.complete and not project.library else None
    mechanism = mechanism_of(robot) if robot else None
    if mechanism is not None and given is not None:
        mechanism = given.started(mechanism)
    tasks = _tasks(cycle)
    elsewhere = None if cycle.ways else _link_elsewhere(project)
    troubles = [] if elsewhere else list(cycle.troubles)
    if cycle.spawned and robot and robot.links and mechanism is None and not elsewhere:
        why = "its links must form one tree, in which each link but the root is the child of exactly one joint"
        troubles.append(trouble_of(robot_not_spawned, ROBOT, why=why))
    support = Support()
    if robot and mechanism is not None:
        commanded = any(task.joints for task in tasks)
        shapes = shapes_of(robot, find_mesh if commanded else None)
        mechanism = with_rims(mechanism, shapes)
        tasks = with_plain_drives(mechanism, shapes, tasks)
        gears = gears_of(project, cycle.distro)
        tasks = with_gears(gears, tasks)
        troubles += gear_troubles(gears, tasks)
        troubles += static_troubles(mechanism, tasks, robot, shapes)
        mechanism = within_ranges(mechanism)
        troubles += loop_troubles(mechanism, tasks, rate)
        troubles += overlap_troubles(mechanism, shapes, _allowed(project))
        support = _support(mechanism, shapes, tasks)
        if support.tips and in_simulation(project, cycle.distro):
            troubles.append(trouble_of(loose_robot_tips_over, ROBOT, when=support.tips))
    return Judgement(
        seen=seen,
        cycle=cycle,
        mechanism=mechanism,
        tasks=tasks,
        rate=rate,
        troubles=tuple(troubles),
        only=tuple(only),
        part_of=elsewhere or "",
        given=given,
        support=support,
    )


def _link_elsewhere(project: Project) -> str | None:
    """The link that a description without controllers hangs on, if that is in another file: it is not a robot."""
    robot = project.robot
    links = {link.name for link in robot.links} if robot else set()
    missing = {joint.parent.name for joint in robot.joints if joint.parent} - links if robot else set()
    children = {joint.child.name for joint in robot.joints if joint.child} if robot else set()
    return missing.pop() if len(missing) == 1 and links == children else None


def _support(mechanism: Mechanism, shapes: Shapes, tasks: Sequence[Task]) -> Support:
    """What a robot rests on that nothing fixes to the world, and that does not drive."""
    moved = {joint for task in tasks for joint in task.joints}
    loose = moved and not mechanism.is_fixed and not any(task.base for task in tasks)
    return support_of(mechanism, shapes, moved) if loose else Support()


def _tasks(cycle: Cycle) -> tuple[Task, ...]:
    """What the active controllers should move, under the names that reports use; each namespace has its manager."""
    active = [way for way in cycle.ways if not way.refusal]
    made: dict[str, Task] = {}
    for namespace in dict.fromkeys(way.configured.controller.namespace for way in active):
        together = [way for way in active if way.configured.controller.namespace == namespace]
        for way, task in zip(together, tasks_of([way.configured for way in together]), strict=True):
            made[way.name] = task._replace(controller=way.name)
    return tuple(made[way.name] for way in active)


def _allowed(project: Project) -> set[frozenset[str]]:
    """The pairs of links whose collisions the SRDF disables."""
    semantic = project.moveit.semantic if project.moveit else None
    return {frozenset(key.text for key in pair) for pair in semantic.pairs} if semantic else set()


def _rate(project: Project, ros: int) -> float:
    managers = project.controllers.managers if project.controllers else ()
    parameters = (manager.parameters.value("update_rate") for manager in managers)
    rate = next((parameter.value for parameter in parameters if parameter is not None), None)
    return float(rate) if isinstance(rate, int | float) and rate > 0 else RATES[ros]


def changed(result: ControllerResult, troubles: Iterable[Trouble]) -> ControllerResult:
    """Return a result with the findings about its controller: an error makes it fail at the stage of the error's rule,
    a warning makes it a warning."""
    own = [
        (trouble, rule_of(trouble.code))
        for trouble in troubles
        if trouble.controller == result.name and trouble.code != verdict_depends_on_distro.code
    ]
    if result.verdict is Verdict.FAILED or not own:
        return result
    for trouble, rule in own:
        if rule.severity is Severity.ERROR and isinstance(rule.stage, Stage):
            return result._replace(verdict=Verdict.FAILED, stage=rule.stage, reason=trouble.message)
    return result._replace(verdict=Verdict.WARNED, reason=own[0][0].message)
