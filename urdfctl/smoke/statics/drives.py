"""The wheels of a mobile base against what its controller assumes: sides, axes, places and measures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from urdfctl.rules.smoke.base_too_slow import base_too_slow
from urdfctl.rules.smoke.steering_range_too_small import steering_range_too_small
from urdfctl.rules.smoke.steering_turns_backwards import steering_turns_backwards
from urdfctl.rules.smoke.wheel_cannot_roll import wheel_cannot_roll
from urdfctl.rules.smoke.wheel_in_the_wrong_place import wheel_in_the_wrong_place
from urdfctl.rules.smoke.wheel_sides_swapped import wheel_sides_swapped
from urdfctl.rules.smoke.wheel_slower_than_commanded import wheel_slower_than_commanded
from urdfctl.rules.smoke.wheel_turns_backwards import wheel_turns_backwards
from urdfctl.rules.smoke.wheels_mirrored import wheels_mirrored
from urdfctl.rules.smoke.wheels_too_weak import wheels_too_weak
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import LATERAL, LEVEL, Hinge, Mechanism, Wheel, is_wheel, wheels_of
from urdfctl.smoke.statics.drive_measures import (
    differ,
    fixed_axle,
    mean_of,
    measure_differs,
    measure_troubles,
    pivots_of,
)
from urdfctl.smoke.statics.efforts import SLOWER, TIME, resisted
from urdfctl.smoke.tasks import FREE, ControllerTask, Drive, MotionFamily, fastest, speed_of

LEAST_STEERING = 0.05
"""A steering joint should turn at least this far to both sides, in rad."""
LEAST_ROLL = 4 * math.pi
"""A wheel that turns less than this, in rad, cannot drive."""
FASTER = 4.0
"""A controller's limit may exceed what its wheels can do by this factor: many limit more than they ever command."""
STEERING_SPEED = 0.5
"""A steering joint should turn this fast, in rad/s."""
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
            yield from measure_troubles(mechanism, task, drive)
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
    if differ(drive.arm, arms):
        yield measure_differs(task, "robot radius", drive.arm, arms)


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


# -- steering and rolling --------------------------------------------------------------------------------------------


def _steering(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    axle = fixed_axle(mechanism, drive)
    for wheel in pivots_of(mechanism, drive):
        hinge, subject = wheel.hinge, f"joint:{wheel.hinge.name}"
        ahead = not axle or wheel.place[0] > mean_of(axle, 0)
        if wheel.axis[2] < LATERAL and (ahead or abs(wheel.axis[2]) < LATERAL):
            how = "to the right" if wheel.axis[2] <= -LATERAL else "about an axis that cannot steer"
            yield trouble_of(steering_turns_backwards, subject, task.controller, (), joint=hinge.name, how=how)
        left = (hinge.effort or 0.0) - hinge.friction
        if hinge.effort and (left <= 0 or left < SLOWER * STEERING_SPEED * hinge.damping):
            yield resisted(hinge, task, STEERING_SPEED)
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
    elif wheels:
        yield from _commanded(task, drive, hinges)
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


def _commanded(task: ControllerTask, drive: Drive, hinges: Sequence[Hinge]) -> Iterator[Trouble]:
    """The controller's own limits against what the slowest wheel can do."""
    most = fastest(drive, hinges)
    slowest = [
        hinge for hinge in hinges if hinge.velocity and hinge.velocity * abs(drive.radius_of(hinge.name)) == most
    ]
    if not slowest:
        return
    turning = drive.turning * drive.separation / 2 if drive.turning < FREE and drive.separation else 0.0
    straight = drive.speed if drive.speed < FREE else 0.0
    if max(straight, turning) <= FASTER * most:
        return
    how = f"drive at {drive.speed:g} m/s" if straight >= turning else f"turn at {drive.turning:g} rad/s"
    hinge = slowest[0]
    fields = {"joint": hinge.name, "how": how, "limit": f"{hinge.velocity:g}", "most": f"{most:.2g}"}
    fields["needed"] = f"{(hinge.velocity or 0.0) * max(straight, turning) / most:.3g}"
    yield trouble_of(wheel_slower_than_commanded, f"joint:{hinge.name}", task.controller, (), **fields)
