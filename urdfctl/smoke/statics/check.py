"""The check of a robot before anything moves: how far each controller gets, and what needs no physics engine."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.hardware.limited_joints import ignores
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.findings.weakening import GUESSED
from urdfctl.lint.results import Outcome
from urdfctl.lint.target import LintedTarget
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.model.stage import Stage
from urdfctl.rules import fault_of, stage_of
from urdfctl.rules.reading.rule_crashed import rule_crashed
from urdfctl.rules.smoke.loose_robot_tips_over import loose_robot_tips_over
from urdfctl.rules.smoke.robot_not_spawned import robot_not_spawned
from urdfctl.rules.smoke.verdict_depends_on_distro import verdict_depends_on_distro
from urdfctl.rules.smoke.wheel_measures_differ import wheel_measures_differ
from urdfctl.smoke.diagnostics import (
    diagnostics_of,
    placed_diagnostics,
    subject_places,
    suppressed_codes,
    unexplained,
)
from urdfctl.smoke.lifecycle import (
    NOT_MOVED,
    ControllerLifecycle,
    RobotLifecycle,
    lifecycle_of,
    place_of,
    result_without_motion,
)
from urdfctl.smoke.results import ROBOT, ControllerResult, RobotResult, Trouble, Verdict, trouble_of
from urdfctl.smoke.robot import Mechanism, Shapes, mechanism_of, shapes_of, with_rims
from urdfctl.smoke.statics.doubts import Doubts, doubts_of, with_doubts
from urdfctl.smoke.statics.loops.stability import loop_troubles, needs_grip
from urdfctl.smoke.statics.loops.velocity_loops import velocity_loop_troubles
from urdfctl.smoke.statics.loose_joints import loose_troubles
from urdfctl.smoke.statics.overlaps import overlap_troubles
from urdfctl.smoke.statics.physics import static_troubles
from urdfctl.smoke.statics.plausibility import plausibility_troubles
from urdfctl.smoke.statics.shared_joints import shared_joint_troubles
from urdfctl.smoke.statics.simulators import in_simulation, movers_of
from urdfctl.smoke.statics.support import Support, support_of
from urdfctl.smoke.statics.transmissions import transmission_troubles, transmissions_of, with_transmissions
from urdfctl.smoke.statics.undriven import tied_by, undriven, with_own_wheels, with_virtual_wheels
from urdfctl.smoke.statics.unknown_parts import MOCKED, needs_of, why_robotless, why_unknown
from urdfctl.smoke.statics.written_limits import written_limit_troubles
from urdfctl.smoke.tasks import ControllerTask, MotionFamily, TaskFile, tasks_of, with_inferred_drives
from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple

_GAINS = ("p", "i", "d")
RATES = {1: 1000.0, 2: 100.0}
"""The default update rate by generation of ROS, in Hz: gazebo_ros_control updates at each step of 1 ms, the controller
manager of ROS 2 at its own default."""
NEEDS_GRIP = "its gains suit wheels that grip the ground, and plain velocity controllers are tested in the air"
NOT_STARTED = "the launch file does not start this controller"
ANOTHER_FITS = "'{}' commands the same joints and fits the robot, and no launch file says which of them is started"


class StaticCheck(NamedTuple):
    """A robot with what its controllers should move, and what is wrong so far.

    seen: the robot as it was linted.
    lifecycle: how far its controllers get without moving.
    mechanism: None if the robot cannot be simulated.
    tasks: what the active controllers should move.
    rate: the update rate of the controllers, in Hz.
    troubles: what is wrong.
    only: the names of the controllers that were asked for, none for all.
    part_of: the link of another file that the description hangs on: it is not a robot then.
    given: the user's own tasks.
    support: what a robot rests on that nothing fixes to the world.
    mocked: whether mock hardware is in the place of its driver.
    doubts: the errors of its controllers that are warnings.
    guessed: whether the arguments of its launch file are guessed.
    """

    seen: LintedTarget
    lifecycle: RobotLifecycle
    mechanism: Mechanism | None
    tasks: tuple[ControllerTask, ...]
    rate: float
    troubles: tuple[Trouble, ...]
    only: tuple[str, ...] = ()
    part_of: str = ""
    given: TaskFile | None = None
    support: Support = Support()
    mocked: bool = False
    doubts: Doubts = {}
    guessed: bool = False

    def wants(self, name: str | None) -> bool:
        """Return whether a controller was asked for. Findings of no controller are always reported."""
        return name is None or not self.only or not {name, name.rpartition("/")[2]}.isdisjoint(self.only)

    @property
    def results(self) -> tuple[ControllerResult, ...]:
        """The results of the controllers, as far as they are known."""
        results = (result_without_motion(each) for each in self.lifecycle.controllers if self.wants(each.name))
        unknown = why_unknown(self.seen) if self.mechanism is None else NOT_MOVED
        known = (each._replace(reason=unknown) if each.reason == NOT_MOVED else each for each in results)
        results = (with_troubles(result, self.troubles) for result in known)
        if self.mocked:
            results = (result._replace(untested={**result.untested, **MOCKED}) for result in results)
        return as_not_started(results, self.not_started)

    @property
    def not_started(self) -> dict[str, str]:
        """The controllers that are most likely not started, each with the reason; none if the user asks for some."""
        if self.guessed:
            return dict.fromkeys((each.name for each in self.lifecycle.controllers), GUESSED)
        return {} if self.only else _controllers_not_started(self.seen.project, self.lifecycle, self.troubles)

    @property
    def _places(self) -> list[tuple[str, Place]]:
        """The place of everything that a finding can be about."""
        project = self.seen.project
        places = {each.name: place_of(each.configured.controller, project) for each in self.lifecycle.controllers}
        of_tasks = [(each.subject, self.given.place_of(each)) for each in self.given.user_tasks] if self.given else []
        known = {name: place for name, place in places.items() if place is not None}
        return [*of_tasks, *subject_places(project, known), *_gain_places(self.lifecycle)]

    def placed(self) -> dict[str, Diagnostic]:
        """Return the place of everything that a finding of an engine can be about."""
        return placed_diagnostics(self._places)

    def suppressed_codes(self) -> dict[str, list[str]]:
        """Return the codes that comments suppress, by subject."""
        return suppressed_codes(self._places, self.lifecycle.causes, list(self.seen.sources.values()))

    @property
    def result(self) -> RobotResult:
        """The smoke test, as far as it is known."""
        linted = self.seen.result
        of_lint = linted.outcome.diagnostics
        troubles = [trouble for trouble in self.troubles if self.wants(trouble.controller)]
        placed = {
            **self.lifecycle.causes,
            **placed_diagnostics(self._places, _subjects_of(troubles)),
        }
        diagnostics = list(diagnostics_of(troubles, placed, self.suppressed_codes(), self.not_started))
        crashes = [finding for finding in of_lint if finding.code == rule_crashed.code]
        outcome = Outcome([*crashes, *diagnostics], [], linted.outcome.crashed)
        return RobotResult(
            linted._replace(outcome=outcome),
            self.results,
            self.lifecycle.distro,
            part_of=self.part_of,
            needs=needs_of(self.seen),
            robotless=why_robotless(self.seen),
            movers=movers_of(self.seen.project),
        )


def _subjects_of(troubles: Iterable[Trouble]) -> set[str]:
    """The subjects of findings, and the controllers that take the place of those that have none."""
    return {subject for trouble in troubles for subject in (trouble.subject, f"controller:{trouble.controller}")}


def _gain_places(lifecycle: RobotLifecycle) -> Iterator[tuple[str, Place]]:
    """The places of gains, for findings about one of them."""
    for each in lifecycle.controllers:
        for parameter in each.configured.controller.parameters.leaves:
            if parameter.last in _GAINS:
                yield f"gain:{each.name}/{parameter.name}", parameter.key


def check_statically(
    seen: LintedTarget,
    only: Sequence[str] = (),
    find_mesh: Callable[[str], str | None] | None = None,
    given: TaskFile | None = None,
) -> StaticCheck:
    """Return the check of a linted robot; of all its controllers, or of those with some names.

    `find_mesh` returns the path of a mesh, or None; without it the meshes are unknown. `given` holds the user's tasks.
    """
    project = seen.project
    lifecycle = lifecycle_of(seen)
    robot = project.robot if lifecycle.spawned and project.complete and not project.library else None
    mechanism = mechanism_of(robot) if robot else None
    if mechanism is not None and given is not None:
        mechanism = given.started(mechanism)
    elsewhere = None if lifecycle.controllers else _link_elsewhere(project)
    troubles = [] if elsewhere else list(lifecycle.troubles)
    if robot and robot.links and mechanism is None and not elsewhere:
        why = "its links must form one tree, in which each link but the root is the child of exactly one joint"
        troubles.append(trouble_of(robot_not_spawned, ROBOT, why=why))
    check = StaticCheck(
        seen=seen,
        lifecycle=lifecycle,
        mechanism=mechanism,
        tasks=_tasks(lifecycle),
        rate=_rate(project, lifecycle.ros),
        troubles=tuple(troubles),
        only=tuple(only),
        part_of=elsewhere or "",
        given=given,
    )
    return _with_physics(check, robot, mechanism, find_mesh) if robot and mechanism is not None else check


def _with_physics(
    check: StaticCheck, robot: Robot, mechanism: Mechanism, find_mesh: Callable[[str], str | None] | None
) -> StaticCheck:
    """The check, to which the physics that needs no engine is added."""
    project, distro = check.seen.project, check.lifecycle.distro
    commanded = any(task.joints for task in check.tasks)
    shapes = shapes_of(robot, find_mesh if commanded else None)
    visuals = shapes_of(robot, None, "visual")
    unlikely = list(plausibility_troubles(mechanism, robot, shapes, visuals))
    mechanism = with_rims(mechanism, shapes)
    transmissions = transmissions_of(project, distro)
    tied = tied_by(robot)
    driving = with_virtual_wheels(project, distro, mechanism, with_own_wheels(mechanism, check.tasks))
    driving = undriven(driving, tied) if tied else with_inferred_drives(mechanism, shapes, driving)
    tasks = with_transmissions(transmissions, driving)
    troubles = [*check.troubles, *unlikely, *transmission_troubles(transmissions, tasks)]
    still = (hinge.name for hinge in mechanism.hinges if hinge.velocity == 0)
    held = {name for name in still if not ignores(project, name, "velocity")}
    troubles += static_troubles(mechanism, tasks, robot, shapes, held)
    if project.started is None:
        troubles += shared_joint_troubles(tasks)
    troubles += written_limit_troubles(mechanism, robot)
    if not tied:
        troubles += loose_troubles(mechanism, tasks, robot, falls=in_simulation(project, distro))
    mechanism = mechanism.within_command_ranges()
    troubles += loop_troubles(mechanism, tasks, check.rate)
    troubles += velocity_loop_troubles(mechanism, tasks, check.rate)
    tasks = tuple(
        task._replace(family=MotionFamily.STRUCTURAL, why=NEEDS_GRIP)
        if needs_grip(mechanism, task, check.rate)
        else task
        for task in tasks
    )
    troubles += overlap_troubles(mechanism, shapes, _allowed(project))
    support = Support(why_not=tied) if tied else _support(mechanism, shapes, tasks)
    if support.tips and in_simulation(project, distro):
        troubles.append(trouble_of(loose_robot_tips_over, ROBOT, when=support.tips))
    doubts = doubts_of(project, distro, tasks)
    told = with_doubts(unexplained(troubles, troubles), doubts)
    return check._replace(mechanism=mechanism, tasks=tasks, troubles=told, support=support, doubts=doubts)


def _link_elsewhere(project: Project) -> str | None:
    """The link that a description without controllers hangs on, if that is in another file: it is not a robot.

    Where not all of the description is known, what is missing may have that link."""
    robot = project.robot
    links = {link.name for link in robot.links} if robot else set()
    missing = {joint.parent.name for joint in robot.joints if joint.parent} - links if robot else set()
    children = {joint.child.name for joint in robot.joints if joint.child} if robot else set()
    return missing.pop() if len(missing) == 1 and links == children and project.complete else None


def _support(mechanism: Mechanism, shapes: Shapes, tasks: Sequence[ControllerTask]) -> Support:
    """What a robot rests on that nothing fixes to the world, and that does not drive."""
    moved = {joint for task in tasks for joint in task.joints}
    loose = moved and not mechanism.is_fixed and not any(task.base for task in tasks)
    return support_of(mechanism, shapes, moved) if loose else Support()


def _tasks(lifecycle: RobotLifecycle) -> tuple[ControllerTask, ...]:
    """What the active controllers should move, under the names that reports use; each namespace has its manager."""
    active = [each for each in lifecycle.controllers if not each.refusal]
    made: dict[str, ControllerTask] = {}
    for namespace in dict.fromkeys(each.configured.controller.namespace for each in active):
        together = [each for each in active if each.configured.controller.namespace == namespace]
        for controller, task in zip(
            together, tasks_of([controller.configured for controller in together]), strict=True
        ):
            made[controller.name] = task._replace(controller=controller.name)
    return tuple(made[each.name] for each in active)


def _allowed(project: Project) -> set[frozenset[str]]:
    """The pairs of links whose collisions the SRDF disables."""
    semantic = project.moveit.semantic if project.moveit else None
    return {frozenset(key.text for key in pair) for pair in semantic.pairs} if semantic else set()


def _rate(project: Project, ros: int) -> float:
    managers = project.controllers.managers if project.controllers else ()
    parameters = (manager.parameters.value("update_rate") for manager in managers)
    rate = next((parameter.value for parameter in parameters if parameter is not None), None)
    return float(rate) if isinstance(rate, int | float) and rate > 0 else RATES[ros]


def with_troubles(result: ControllerResult, troubles: Iterable[Trouble]) -> ControllerResult:
    """Return a result with the findings about its controller: an error makes it fail at the stage of the error,
    a warning makes it a warning."""
    own = [
        (trouble, fault_of(trouble.code))
        for trouble in troubles
        if trouble.controller == result.name and trouble.code != verdict_depends_on_distro.code
    ]
    if result.verdict is Verdict.FAILED or not own:
        return result
    for trouble, fault in own:
        stage = stage_of(fault.code)
        if fault.severity is Severity.ERROR and isinstance(stage, Stage) and not trouble.doubt:
            return result._replace(verdict=Verdict.FAILED, stage=stage, reason=trouble.message)
    return result._replace(verdict=Verdict.WARNED, reason=own[0][0].message)


# -- controllers that are most likely not started --------------------------------------------------------------------


def _controllers_not_started(
    project: Project, lifecycle: RobotLifecycle, troubles: Iterable[Trouble]
) -> dict[str, str]:
    """Return the controllers that are most likely not started, each with the reason.

    These are the ones that the launch file neither starts nor loads. Without a launch file, they are drives that have
    the measures of another robot, if another controller of the same joints has those of this one.
    """
    launch = project.launch
    if launch is not None:
        loaded = {name.rpartition("/")[2] for spawn in launch.spawns for name, _ in spawn.names}
        absent = (each.name for each in lifecycle.controllers if each.name.rpartition("/")[2] not in loaded)
        return {} if project.started is None else dict.fromkeys(absent, NOT_STARTED)
    misfits = {trouble.controller for trouble in troubles if trouble.code == wheel_measures_differ.code}
    fitting = {_commanded(each): each.name for each in lifecycle.controllers if each.name not in misfits}
    others = ((each.name, fitting.get(_commanded(each))) for each in lifecycle.controllers if each.name in misfits)
    return {name: ANOTHER_FITS.format(other) for name, other in others if other}


def as_not_started(results: Iterable[ControllerResult], not_started: Mapping[str, str]) -> tuple[ControllerResult, ...]:
    """Return results, in which controllers that are most likely not started are warned where they would fail."""
    return tuple(
        result._replace(verdict=Verdict.WARNED, reason=f"{_would_fail(why)}: {result.reason}")
        if result.verdict is Verdict.FAILED and (why := not_started.get(result.name))
        else result
        for result in results
    )


def _would_fail(why: str) -> str:
    return "with guessed arguments it fails" if why == GUESSED else "most likely not started; it would fail"


def _commanded(controller: ControllerLifecycle) -> frozenset[str]:
    return frozenset(claim.name for claim in controller.configured.claimed(ClaimKind.COMMAND))
