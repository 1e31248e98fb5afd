"""The wheels of a mobile base against what its controller assumes: sides, axes, places and measures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from urdfctl.rules.smoke.base_too_slow import base_too_slow
from urdfctl.rules.smoke.steering_range_too_small import steering_range_too_small
from urdfctl.rules.smoke.steering_turns_backwards import steering_turns_backwards
from urdfctl.rules.smoke.wheel_cannot_roll import wheel_cannot_roll
from urdfctl.rules.smoke.wheel_in_the_wrong_place import wheel_in_the_wrong_place
from urdfctl.rules.smoke.wheel_measures_differ import wheel_measures_differ
from urdfctl.rules.smoke.wheel_sides_swapped import wheel_sides_swapped
from urdfctl.rules.smoke.wheel_turns_backwards import wheel_turns_backwards
from urdfctl.rules.smoke.wheels_mirrored import wheels_mirrored
from urdfctl.rules.smoke.wheels_too_weak import wheels_too_weak
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import LATERAL, LEVEL, Mechanism, Wheel, is_wheel, wheels_of
from urdfctl.smoke.statics.efforts import SLOWER, TIME, resisted
from urdfctl.smoke.tasks import ControllerTask, Drive, MotionFamily, fastest, speed_of

MEASURES_DIFFER = 0.15
"""The accepted relative difference of a wheel's radius, or of the wheel separation, from the controller's parameter."""
LEAST_STEERING = 0.05
"""A steering joint should turn at least this far to both sides, in rad."""
LEAST_ROLL = 4 * math.pi
"""A wheel that turns less than this, in rad, cannot drive."""
LEAST_SPEED = 0.02
"""A base should be able to drive this fast, in m/s."""


def drive_troubles(mechanism: Mechanism, tasks: Sequence[ControllerTask]) -> Iterator[Trouble]:
    """Yield what is wrong with the wheels of mobile bases."""
    inferred: set[Drive] = set()
    for task in tasks:
        drive = task.base
        if drive is not None and drive not in inferred:
            everyone = wheels_of(mechanism, task.driven_joints, drive.base)
            yield from _sides(mechanism, task, drive)
            yield from _places(mechanism, task, drive)
            yield from _order(mechanism, task, drive)
            if drive.is_inferred:
                inferred.add(drive)
            elif drive.angles:
                yield from _around(task, drive, everyone)
            else:
                yield from _axes(task, everyone)
            yield from _radii(mechanism, task, drive)
            yield from _apart(mechanism, task, drive)
            yield from _steering(mechanism, task, drive)
            yield from _rolling(mechanism, task, drive, everyone)
    yield from _mirrored(mechanism, tasks)


# -- sides and places ------------------------------------------------------------------------------------------------


def _sides(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    left, right = (wheels_of(mechanism, names, drive.base) for names in (drive.left, drive.right))
    if not left or not right:
        return
    sides = [wheel.place[1] for wheel in (*left, *right)]
    middle = (max(sides) + min(sides)) / 2
    sided = [*((wheel, 1) for wheel in left), *((wheel, -1) for wheel in right)]
    wrong = [(wheel, side) for wheel, side in sided if side * (wheel.place[1] - middle) < -LEVEL]
    subject = f"controller:{task.controller}"
    if len(wrong) == len(left) + len(right):
        note = "the robot turns right when commanded to turn left: swap the wheel names, or the signs of y"
        names = {"left": left[0].hinge.name, "right": right[0].hinge.name}
        yield trouble_of(wheel_sides_swapped, subject, task.controller, (note,), **names)
        return
    for wheel, side in wrong:
        role, actual = ("left", "right") if side > 0 else ("right", "left")
        yield _misplaced(task, wheel, f"a {role} wheel", f"on the {actual} side")


def _order(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    """The steering controllers of ROS 2 take two wheels or pivots as the right and the left one, in this order."""
    for names in (drive.driven, drive.steered) if drive.steered else ():
        wheels = wheels_of(mechanism, names, drive.base)
        if len(wheels) == 2 == len(names) and wheels[0].place[1] - wheels[1].place[1] > LEVEL:  # noqa: PLR2004
            yield _misplaced(
                task, wheels[0], "the right wheel", "on the left side: the right one comes first in the list"
            )


def _misplaced(task: ControllerTask, wheel: Wheel, role: str, actual: str) -> Trouble:
    fields = {"joint": wheel.hinge.name, "role": role, "actual": actual}
    return trouble_of(wheel_in_the_wrong_place, f"controller:{task.controller}", task.controller, (), **fields)


def _places(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    """Wheels for which the controller has names such as 'front left'."""
    wheels = wheels_of(mechanism, [name for name, _, _ in drive.roles], drive.base)
    if len(wheels) != len(drive.roles) or not wheels:
        return
    middle = [sum(wheel.place[n] for wheel in wheels) / len(wheels) for n in range(2)]
    for wheel, (_, ahead, aside) in zip(wheels, drive.roles, strict=True):
        x, y = (wheel.place[n] - middle[n] for n in range(2))
        if ahead * x < -LEVEL or aside * y < -LEVEL:
            role = f"its {'front' if ahead > 0 else 'rear'} {'left' if aside > 0 else 'right'} wheel"
            actual = f"at the {'front' if x > 0 else 'rear'} {'left' if y > 0 else 'right'}"
            yield _misplaced(task, wheel, role, actual)


def _axes(task: ControllerTask, wheels: Sequence[Wheel]) -> Iterator[Trouble]:
    for wheel in wheels:
        if wheel.axis[1] >= LATERAL:
            continue
        how = "backwards" if wheel.axis[1] <= -LATERAL else "about an axis that cannot roll it forward"
        shown = " ".join(f"{round(part, 3) + 0.0:g}" for part in wheel.axis)  # not -0
        note = f"its axis in the base frame is {shown}; a wheel that rolls forward turns about 0 1 0"
        subject = f"joint:{wheel.hinge.name}"
        yield trouble_of(wheel_turns_backwards, subject, task.controller, (note,), joint=wheel.hinge.name, how=how)


def _around(task: ControllerTask, drive: Drive, wheels: Sequence[Wheel]) -> Iterator[Trouble]:
    """The wheels of an omnidirectional base: each has its direction from the centre, and its axis points outwards."""
    if len(wheels) != len(drive.angles):
        return
    for wheel, angle in zip(wheels, drive.angles, strict=True):
        out = (math.cos(angle), math.sin(angle))
        along = wheel.axis[0] * out[0] + wheel.axis[1] * out[1]
        away = math.hypot(wheel.place[0], wheel.place[1])
        if away > LEVEL and (wheel.place[0] * out[0] + wheel.place[1] * out[1]) / away < LATERAL:
            real = math.degrees(math.atan2(wheel.place[1], wheel.place[0])) % 360
            yield _misplaced(task, wheel, f"its wheel at {math.degrees(angle) % 360:.3g}°", f"at {real:.3g}°")
        elif along < LATERAL:
            how = "backwards" if along <= -LATERAL else "about an axis that does not point outwards"
            subject, name = f"joint:{wheel.hinge.name}", wheel.hinge.name
            yield trouble_of(wheel_turns_backwards, subject, task.controller, (), joint=name, how=how)
    arms = sum(math.hypot(wheel.place[0], wheel.place[1]) for wheel in wheels) / len(wheels)
    if _differ(drive.arm, arms):
        yield _measure_differs(task, "robot radius", drive.arm, arms)


def _mirrored(mechanism: Mechanism, tasks: Sequence[ControllerTask]) -> Iterator[Trouble]:
    """Wheels under plain velocity controllers: a positive velocity should roll both sides the same way."""
    owners = {
        name: task.controller
        for task in tasks
        if task.family is MotionFamily.FORWARD and task.interface == "velocity"
        for name in task.joints
    }
    wheels = [wheel for wheel in wheels_of(mechanism, list(owners), "") if is_wheel(mechanism, wheel)]
    bottoms = [wheel.place[2] - (mechanism.bodies[wheel.hinge.child].radius or 0.0) for wheel in wheels]
    lowest = min(bottoms, default=0.0)
    standing = [wheel for wheel, bottom in zip(wheels, bottoms, strict=True) if bottom < lowest + LEVEL]
    forward = [wheel for wheel in standing if wheel.axis[1] > 0]
    backward = [wheel for wheel in standing if wheel.axis[1] < 0]
    apart = {wheel.place[1] > 0 for wheel in standing}
    if forward and backward and len(apart) == 2:  # noqa: PLR2004 (wheels on both sides)
        odd = (backward if len(backward) <= len(forward) else forward)[0].hinge.name
        other = (forward if len(backward) <= len(forward) else backward)[0].hinge.name
        yield trouble_of(wheels_mirrored, f"joint:{odd}", owners[odd], (), joint=odd, other=other)


# -- measures --------------------------------------------------------------------------------------------------------


def _radii(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    given = {name: drive.radius_of(name) for name in task.driven_joints}
    real = {
        name: mechanism.bodies[hinge.child].radius for name in given if (hinge := mechanism.hinge(name)) is not None
    }
    wrong = [name for name, radius in real.items() if radius and _differ(given[name], radius)]
    if wrong and len({round(real[name] or 0.0, 4) for name in wrong}) == 1 and len(wrong) == len(real):
        yield _measure_differs(task, "wheel radius", given[wrong[0]], real[wrong[0]] or 0.0)
        return
    for name in wrong:
        yield _measure_differs(task, f"radius of wheel '{name}'", given[name], real[name] or 0.0)


def _apart(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    """The distances between wheels. More than two driven wheels slip, so that theirs is not a measure."""
    left, right, driven = (wheels_of(mechanism, names, drive.base) for names in (drive.left, drive.right, drive.driven))
    if len(left) == 1 == len(right):
        apart = abs(left[0].place[1] - right[0].place[1])
        if _differ(drive.separation, apart):
            yield _measure_differs(task, "wheel separation", drive.separation, apart)
    steered = _pivots(mechanism, drive)
    if len(drive.roles) == len(driven) == 4:  # noqa: PLR2004
        spans = (max(w.place[n] for w in driven) - min(w.place[n] for w in driven) for n in range(2))
        reach = sum(spans) / 2
        if _differ(drive.reach, reach):
            yield _measure_differs(task, "half wheelbase plus half track", drive.reach, reach)
    if driven and steered:
        length = abs(_mean(driven, 0) - _mean(steered, 0))
        if _differ(drive.wheelbase, length):
            yield _measure_differs(task, "wheelbase", drive.wheelbase, length)
    for name, wheels, given in (("traction", driven, drive.track), ("steering", steered, drive.steering_track)):
        if len(wheels) == 2 and _differ(given, abs(wheels[0].place[1] - wheels[1].place[1])):  # noqa: PLR2004
            yield _measure_differs(task, f"{name} track width", given, abs(wheels[0].place[1] - wheels[1].place[1]))


def _pivots(mechanism: Mechanism, drive: Drive) -> list[Wheel]:
    return wheels_of(mechanism, drive.steered, drive.base)


def _mean(wheels: Sequence[Wheel], way: int) -> float:
    return sum(wheel.place[way] for wheel in wheels) / len(wheels)


def _measure_differs(task: ControllerTask, measure: str, expected: float, actual: float) -> Trouble:
    subject, fields = f"controller:{task.controller}", {"measure": measure}
    shown = {"expected": f"{expected:g}", "actual": f"{actual:.3g}"}
    return trouble_of(wheel_measures_differ, subject, task.controller, (), **fields, **shown)


def _differ(given: float, real: float) -> bool:
    return given > 0 and real > 0 and abs(given / real - 1) > MEASURES_DIFFER


# -- steering and rolling --------------------------------------------------------------------------------------------


def _steering(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    driven = wheels_of(mechanism, drive.driven, drive.base)
    for wheel in _pivots(mechanism, drive):
        hinge, subject = wheel.hinge, f"joint:{wheel.hinge.name}"
        ahead = not driven or wheel.place[0] > _mean(driven, 0)
        if wheel.axis[2] < LATERAL and (ahead or abs(wheel.axis[2]) < LATERAL):
            how = "to the right" if wheel.axis[2] <= -LATERAL else "about an axis that cannot steer"
            yield trouble_of(steering_turns_backwards, subject, task.controller, (), joint=hinge.name, how=how)
        reach = max(0.0, min(-hinge.span[0], hinge.span[1]))
        if hinge.type != "continuous" and reach < LEAST_STEERING:
            radius = drive.wheelbase / math.tan(reach) if reach else 0.0
            notes = (f"the smallest circle has a radius of {radius:.3g} m",) if radius else ()
            fields = {"joint": hinge.name, "reach": f"{reach:.2g}"}
            yield trouble_of(steering_range_too_small, subject, task.controller, notes, **fields)


def _rolling(mechanism: Mechanism, task: ControllerTask, drive: Drive, wheels: Sequence[Wheel]) -> Iterator[Trouble]:
    """Driven wheels must turn without end, against friction and damping, and accelerate the robot."""
    hinges = [wheel.hinge for wheel in wheels]
    speed, thrust, known = speed_of(drive, hinges), 0.0, bool(wheels)
    top = min(drive.speed, fastest(drive, hinges))
    if wheels and top < LEAST_SPEED:
        why = "its own velocity limit" if drive.speed <= top else "the velocity limits of its wheels"
        subject, shown = f"controller:{task.controller}", f"{top:.2g}"
        yield trouble_of(base_too_slow, subject, task.controller, (), speed=shown, why=why)
    for wheel in wheels:
        hinge = wheel.hinge
        radius = abs(drive.radius_of(hinge.name)) or mechanism.bodies[hinge.child].radius
        low, high = hinge.span
        if hinge.type != "continuous" and (hinge.type == "prismatic" or high - low < LEAST_ROLL):
            fields = {"joint": hinge.name, "kind": hinge.type, "low": low, "high": high}
            yield trouble_of(wheel_cannot_roll, f"joint:{hinge.name}", task.controller, (), **fields)
        if not hinge.effort or not radius:
            known = False
            continue
        left = hinge.effort - hinge.friction
        if left <= 0 or left < SLOWER * hinge.damping * speed / radius:
            yield resisted(hinge, task, speed / radius)
            known = False
        thrust += max(0.0, left) / radius
    mass = sum(body.mass for body in mechanism.bodies.values())
    if known and 0 < thrust * TIME < mass * speed:  # without any thrust, a value is not a number
        seconds = f"{mass * speed / thrust:.2g}"
        fields = {"thrust": f"{thrust:.3g}", "mass": f"{mass:.3g}", "speed": f"{speed:g}", "seconds": seconds}
        yield trouble_of(wheels_too_weak, f"controller:{task.controller}", task.controller, (), **fields)
