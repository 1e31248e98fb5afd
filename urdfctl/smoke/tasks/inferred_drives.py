"""Plain velocity controllers on wheels that form the drive of a base: without a controller that knows the base."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.smoke.robot import LEVEL, TOUCHING, Mechanism, Shapes, Wheel, is_wheel, rest_pose_of, wheels_of
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily


def with_inferred_drives(
    mechanism: Mechanism, shapes: Shapes, tasks: Sequence[ControllerTask]
) -> tuple[ControllerTask, ...]:
    """Return the tasks, in which velocity controllers that move nothing but the wheels of a base drive this base.

    The base stands on wheels, which are on both sides, and no other controller drives it. Wheels of one side turn
    about the same direction. Those of the other side may be mirrored.
    """
    if mechanism.is_fixed or any(task.base for task in tasks):
        return tuple(tasks)
    wheels = {name: wheel for task in tasks if (found := _wheels(mechanism, task)) for name, wheel in found.items()}
    drive = _drive(mechanism, list(wheels.values()))
    if drive is None or not _stands(mechanism, shapes, list(wheels.values())):
        return tuple(tasks)
    return tuple(
        task._replace(drive=drive) if {*task.joints} <= wheels.keys() and task.joints else task for task in tasks
    )


def _wheels(mechanism: Mechanism, task: ControllerTask) -> dict[str, Wheel]:
    """The wheels of a velocity controller, or none if it moves other joints too."""
    if task.family is not MotionFamily.FORWARD or task.interface != "velocity":
        return {}
    wheels = wheels_of(mechanism, task.joints, mechanism.root)
    only = len(wheels) == len(task.joints) and all(is_wheel(mechanism, wheel) for wheel in wheels)
    return {wheel.hinge.name: wheel for wheel in wheels} if only else {}


def _drive(mechanism: Mechanism, wheels: Sequence[Wheel]) -> Drive | None:
    sides = [[wheel for wheel in wheels if side * wheel.place[1] > LEVEL] for side in (1, -1)]
    radii = [mechanism.bodies[wheel.hinge.child].radius or 0.0 for wheel in wheels]
    if not all(sides) or sum(map(len, sides)) < len(wheels) or max(radii) - min(radii) > LEVEL:
        return None
    signs = [{1.0 if wheel.axis[1] > 0 else -1.0 for wheel in side} for side in sides]
    if any(len(sign) > 1 for sign in signs):
        return None
    left, right = ([wheel.hinge.name for wheel in side] for side in sides)
    apart = sum(abs(wheel.place[1]) for wheel in wheels) / len(wheels) * 2
    return Drive(
        tuple(left),
        tuple(right),
        radius=radii[0],
        separation=apart,
        left_scale=signs[0].pop(),
        right_scale=signs[1].pop(),
        is_inferred=True,
    )


def _stands(mechanism: Mechanism, shapes: Shapes, wheels: Sequence[Wheel]) -> bool:
    """Whether one of the wheels at least touches the ground when the robot rests on it."""
    at_rest = rest_pose_of(mechanism, shapes) if shapes.complete else None
    return at_rest is not None and any(at_rest.heights.get(w.hinge.child, 1.0) <= TOUCHING for w in wheels)
