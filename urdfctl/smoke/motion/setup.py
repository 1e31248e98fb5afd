"""The robot as an engine loads it, before anything moves."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.smoke.engines import STEP, EngineSetup
from urdfctl.smoke.motion.plan import MotionPlan
from urdfctl.smoke.robot import moved_inertias

MOST_DAMPED = 0.5
"""An explicit damping force may change a joint's velocity by this fraction in a step; from twice the velocity on the
simulation would explode."""


def engine_setup(plan: MotionPlan) -> EngineSetup:
    """Return the setup with which an engine loads the robot of a plan."""
    mechanism = plan.mechanism
    weightless = [body.name for body in mechanism.bodies.values() if not body.falls]
    wheels = list(wheel_joints(plan))
    return EngineSetup(
        urdf=plan.urdf,
        root=mechanism.root,
        fixed=plan.fixed,
        start=mechanism.start(),
        weightless=weightless,
        wheels=wheels,
        gui=plan.gui,
        resist={h.name: (h.friction, h.damping) for h in mechanism.hinges if h.moves and (h.friction or h.damping)},
        stiff=stiff_joints(plan),
        skidding={hinge.child: hinge.axis for hinge in mechanism.hinges if hinge.name in skidding_joints(plan)},
        grips={body.name: body.grip for body in mechanism.bodies.values() if body.grip is not None},
    )


def wheel_joints(plan: MotionPlan) -> Iterator[str]:
    """Yield the links that grip the ground: driven wheels, and whatever a steering joint turns."""
    mechanism = plan.mechanism
    for drive in (task.drive for task in plan.tasks if task.drive):
        for hinge in mechanism.hinges:
            if hinge.name in drive.wheels:
                yield hinge.child
            elif hinge.name in drive.steered:
                yield from mechanism.below(hinge.child)


def skidding_joints(plan: MotionPlan) -> set[str]:
    """Return the joints of the wheels of bases that turn by letting more than two wheels slip."""
    drives = [task.drive for task in plan.tasks if task.drive and task.drive.is_skidding]
    return {name for drive in drives for name in drive.wheels}


def stiff_joints(plan: MotionPlan) -> tuple[str, ...]:
    """Return the joints that are pushed by efforts, and whose damping an engine cannot compute explicitly."""
    if plan.engine != "pybullet":
        return ()
    inertias = moved_inertias(plan.mechanism)
    pushed = {joint for task in plan.tasks if task.interface == "effort" for joint in task.joints}
    return tuple(
        hinge.name
        for hinge in plan.mechanism.hinges
        if hinge.name in pushed and hinge.damping * STEP > MOST_DAMPED * inertias.get(hinge.name, 0.0)
    )
