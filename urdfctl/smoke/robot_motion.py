"""The motion of a checked robot: the plan that an engine gets, and what its result adds to that of the robot."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial

from urdfctl.load.meshes import mesh_path
from urdfctl.model.stage import Stage
from urdfctl.rules.smoke.collision_mesh_left_out import collision_mesh_left_out
from urdfctl.rules.smoke.effort_too_weak_for_gravity import effort_too_weak_for_gravity
from urdfctl.rules.smoke.engine_died import engine_died
from urdfctl.rules.smoke.engine_refuses_robot import engine_refuses_robot
from urdfctl.rules.smoke.inertia_unusable import inertia_unusable
from urdfctl.run.limits import WorkerFailure
from urdfctl.smoke.checked_robot import CheckedRobot
from urdfctl.smoke.diagnostics import diagnostics_of, unexplained
from urdfctl.smoke.engines import EngineUrdf, engine_urdf, wheel_links
from urdfctl.smoke.motion import MotionPlan, SimulationResult
from urdfctl.smoke.results import ROBOT, ControllerResult, RobotResult, Trouble, Verdict, trouble_of
from urdfctl.smoke.robot import Mechanism
from urdfctl.smoke.statics import StaticCheck, as_not_started, with_doubts, with_troubles
from urdfctl.smoke.tasks import MOTION, Drive
from urdfctl.source.workspaces.packages import Packages

MOST_BODIES = 800
"""A robot with more links than this is not simulated: pybullet takes minutes for a chain of a thousand links."""


def plan_of(
    static_check: StaticCheck, packages: Packages, duration: float = MOTION, *, gui: bool = False
) -> tuple[MotionPlan | None, list[Trouble]]:
    """Return the plan, or None if there is nothing to move, and what was found while making it."""
    mechanism, robot = static_check.mechanism, static_check.seen.project.robot
    unusable = any(trouble.code == inertia_unusable.code for trouble in static_check.troubles)
    if mechanism is None or robot is None or unusable:
        return None, []
    refused = _refusal(mechanism)
    if refused is not None:
        return None, [refused]
    tasks = tuple(task for task in static_check.tasks if static_check.wants(task.controller))
    drives = [task.drive for task in tasks if task.drive]
    wheels = _wheels(mechanism, drives)
    damped = {joint for task in tasks if task.interface == "effort" for joint in task.joints}
    find_mesh = partial(mesh_path, packages=packages, robot_file=static_check.seen.result.path)

    def on_ground(*, standing: bool) -> EngineUrdf:
        return engine_urdf(robot, mechanism, find_mesh, wheels, standing=standing, damped=damped)

    ready = on_ground(standing=bool(drives))
    support = static_check.support
    plan = MotionPlan(
        engine="",
        urdf=ready.urdf,
        mechanism=mechanism,
        tasks=tasks,
        rate=static_check.rate,
        fixed=not drives,
        shapeless=bool(ready.left_out),
        duration=duration,
        gui=gui,
        ground_urdf=on_ground(standing=True).urdf if support.links and not support.why_not else "",
        why_held=support.why_not,
        user_tasks=tuple(each for each in static_check.given.user_tasks if static_check.wants(each.controller))
        if static_check.given
        else (),
    )
    return plan, troubles_of_left_out(ready) if drives else troubles_of_left_out(ready._replace(left_out=ready.broken))


def _refusal(mechanism: Mechanism) -> Trouble | None:
    """That no engine can move a robot: MuJoCo rejects a joint without a direction, and pybullet's positions explode."""
    if len(mechanism.bodies) > MOST_BODIES:
        why = f"it has {len(mechanism.bodies)} links, and the limit is {MOST_BODIES}"
        return trouble_of(engine_refuses_robot, ROBOT, engine="the smoke test", why=why)
    for hinge in mechanism.hinges:
        if hinge.moves and hinge.type != "prismatic" and not any(hinge.axis):
            why = f"the axis of joint '{hinge.name}' is 0 0 0; give it a direction"
            return trouble_of(engine_refuses_robot, f"joint:{hinge.name}", engine="the smoke test", why=why)
    return None


def _wheels(mechanism: Mechanism, drives: Iterable[Drive]) -> dict[str, float]:
    """The links of wheels, each with the radius that its controller uses, in m."""
    wheels: dict[str, float] = {}
    for drive in drives:
        wheels |= wheel_links(mechanism, (*drive.wheels, *drive.steered), drive.radius)
    return wheels


def troubles_of_left_out(ready: EngineUrdf) -> list[Trouble]:
    """Return what is to be told of the parts that an engine does not get."""
    if not ready.left_out:
        return []
    (link, why), *others = ready.left_out.items()
    links = f"{len(others)} other link{'s' if len(others) > 1 else ''}"
    more = f", and that of {links}" if others else ""
    return [trouble_of(collision_mesh_left_out, f"link:{link}", link=link, more=more, why=why)]


# -- the results of engines ------------------------------------------------------------------------------------------


def with_engine_result(
    result: RobotResult, robot: CheckedRobot, engine: str, trial: SimulationResult | WorkerFailure
) -> RobotResult:
    """Return the result of a robot, to which what an engine found is added."""
    if isinstance(trial, WorkerFailure):
        troubles = [trouble_of(engine_died, ROBOT, engine=engine, why=trial.reason)]
        trial = _not_simulated(result, f"{engine} crashed")
    elif trial.refused:
        troubles = [trouble_of(engine_refuses_robot, ROBOT, engine=engine, why=trial.refused)]
        trial = _not_simulated(result, f"{engine} rejects the robot")
    else:
        troubles = list(with_doubts(_new(trial.troubles, robot), robot.doubts))
    diagnostics = result.linted.outcome.diagnostics
    messages = {diagnostic.message for diagnostic in diagnostics}
    found = diagnostics_of(troubles, robot.placed, robot.suppressed, robot.not_started)
    new = [diagnostic for diagnostic in found if diagnostic.message not in messages]
    outcome = result.linted.outcome._replace(diagnostics=[*diagnostics, *new])
    after = (_with_trial(controller, trial, troubles) for controller in result.controllers)
    controllers = as_not_started(after, robot.not_started)
    name = f"{result.engine} and {engine}" if result.engine else engine
    seconds = result.seconds + trial.seconds
    linted = result.linted._replace(outcome=outcome)
    return result._replace(
        linted=linted, controllers=controllers, engine=name, seconds=seconds, curves=result.curves or trial.curves
    )


def _not_simulated(result: RobotResult, why: str) -> SimulationResult:
    return SimulationResult(unjudged={controller.name: f"not simulated: {why}" for controller in result.controllers})


def _new(troubles: Sequence[Trouble], robot: CheckedRobot) -> list[Trouble]:
    """The findings of an engine without those that known findings explain, or are."""
    known = robot.troubles
    same = {(trouble.subject, trouble.code) for trouble in known}
    carried = dict(_falling(robot.plan.mechanism, known)) if robot.plan else {}
    return [trouble for trouble in unexplained(troubles, known, carried) if (trouble.subject, trouble.code) not in same]


def _falling(mechanism: Mechanism, known: Sequence[Trouble]) -> Iterator[tuple[str, set[str]]]:
    """Yield each joint that cannot hold its load, with the joints on it, as subjects of findings."""
    weak = {trouble.subject for trouble in known if trouble.code == effort_too_weak_for_gravity.code}
    for hinge in mechanism.hinges:
        if f"joint:{hinge.name}" in weak:
            links = mechanism.below(hinge.child)
            yield f"joint:{hinge.name}", {f"joint:{other.name}" for other in mechanism.hinges if other.parent in links}


def _with_trial(controller: ControllerResult, trial: SimulationResult, troubles: Sequence[Trouble]) -> ControllerResult:
    """The result after simulating: a controller passes only if it moved its joints, or commands nothing."""
    acts = tuple(dict.fromkeys((*controller.tested, *trial.tested.get(controller.name, ()))))
    untested = {**controller.untested, **trial.untested.get(controller.name, {})}
    seconds = controller.seconds + trial.times.get(controller.name, 0.0)
    controller = controller._replace(tested=acts, untested=untested, seconds=seconds)
    if controller.verdict is Verdict.SKIPPED:
        if controller.name in trial.moved:
            controller = controller._replace(verdict=Verdict.PASSED, stage=Stage.DEACTIVATE, reason="")
        else:
            controller = controller._replace(reason=trial.unjudged.get(controller.name, controller.reason))
    elif controller.verdict is Verdict.WARNED and controller.name in trial.moved and not controller.by_distro:
        controller = controller._replace(stage=Stage.DEACTIVATE)
    return with_troubles(controller, troubles)
