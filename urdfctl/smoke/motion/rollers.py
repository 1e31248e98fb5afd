"""Bases whose wheels have rollers, mecanum and omnidirectional: how they move, by the Jacobian of their wheels.

Engines do not model rollers. The wheels turn in the air, as fast as their motors allow, and the motion of the base
follows from where they are and about which axes they turn.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.model.geometry import Square, inner
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left
from urdfctl.smoke.matrices import inverted
from urdfctl.smoke.motion.checks import STRAIGHT, STRAIGHT_YAW
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Mechanism, Wheel, wheels_of
from urdfctl.smoke.tasks import PART_OF_SPEED, TURN, ControllerTask, Drive, speed_of
from urdfctl.startup.records import NamedTuple

_SINGULAR = 1e-9
"""Wheels whose Jacobian has a smaller determinant, in m², cannot move the base in all three ways."""


class Twist(NamedTuple):
    """A motion of a base: forward and to the left in m, and turning left in rad; or the rates of these."""

    ahead: float = 0.0
    left: float = 0.0
    turn: float = 0.0


def commands(mechanism: Mechanism, drive: Drive) -> Iterator[Twist]:
    """Yield the velocities with which a base is tested one by one, as fast as its controller and its wheels allow."""
    hinges = [hinge for name in drive.driven if (hinge := mechanism.hinge(name)) is not None]
    limits = {hinge.name: hinge.velocity for hinge in hinges if hinge.velocity}
    speed = speed_of(drive, hinges)
    for twist in (Twist(ahead=speed), Twist(left=speed), Twist(turn=min(TURN, drive.turning))):
        speeds = wheel_speeds(drive, twist)
        parts = [PART_OF_SPEED * limits[name] / abs(speeds[name]) for name in limits if speeds[name]]
        part = min([1.0, *parts])
        yield Twist(*(value * part for value in twist))


def wheel_speeds(drive: Drive, twist: Twist) -> dict[str, float]:
    """Return the velocity that a controller commands to each wheel, in rad/s.

    As in mecanum_drive_controller.cpp update_and_write_commands() and omni_wheel_drive_controller.cpp
    compute_and_set_wheel_velocities().
    """
    if drive.angles:
        rims = {
            name: math.sin(angle) * twist.ahead - math.cos(angle) * twist.left - drive.arm * twist.turn
            for name, angle in zip(drive.driven, drive.angles, strict=True)
        }
    else:
        rims = {
            name: twist.ahead - front * left * twist.left - left * drive.reach * twist.turn
            for name, front, left in drive.roles
        }
    return {name: speed / drive.radius for name, speed in rims.items()}


def motion_of_base(mechanism: Mechanism, drive: Drive, angles: Mapping[str, float]) -> Twist | None:
    """Return how a base moves if its wheels turn by some angles, in rad; None if they cannot move it in all ways."""
    wheels = wheels_of(mechanism, drive.driven, drive.base)
    middle = [sum(wheel.place[n] for wheel in wheels) / len(wheels) for n in range(2)]
    rows, rolled = [], []
    for wheel in wheels:
        x, y = (wheel.place[n] - middle[n] for n in range(2))
        grip = _gripping(wheel, x, y, omni=bool(drive.angles))
        radius = mechanism.bodies[wheel.hinge.child].radius or drive.radius
        rows.append([grip[0], grip[1], grip[1] * x - grip[0] * y])
        rolled.append(radius * angles[wheel.hinge.name] * (grip[0] * wheel.axis[1] - grip[1] * wheel.axis[0]))
    solved = _least_squares(rows, rolled)
    return Twist(*solved) if solved else None


def _gripping(wheel: Wheel, x: float, y: float, *, omni: bool) -> tuple[float, float]:
    """The direction in which the ground holds a wheel: across the axis of the roller that touches it.

    The rollers of an omnidirectional wheel turn about its rim, those of a mecanum wheel at 45° to its axis. Seen from
    above, the rollers of four mecanum wheels form the letter X, and touch the ground like a rhombus.
    """
    if omni:
        length = math.hypot(wheel.axis[0], wheel.axis[1]) or 1.0
        return wheel.axis[1] / length, -wheel.axis[0] / length
    return 1.0, -math.copysign(1.0, x * y)


def _least_squares(rows: Sequence[Sequence[float]], values: Sequence[float]) -> list[float] | None:
    columns = list(zip(*rows, strict=True))
    normal: Square = [[inner(a, b) for b in columns] for a in columns]
    (a, b, c), (d, e, f), (g, h, i) = normal
    if abs(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)) < _SINGULAR:
        return None
    right = [inner(column, values) for column in columns]
    return [inner(row, right) for row in inverted(normal)]


def roller_troubles(task: ControllerTask, wanted: Twist, actual: Twist) -> Iterator[Trouble]:
    """Yield what is wrong if a base should move in one of the three ways."""
    subject, controller = f"controller:{task.controller}", task.controller
    if wanted.turn:
        if not STRAIGHT[0] < actual.turn / wanted.turn < STRAIGHT[1]:
            yield trouble_of(does_not_turn_left, subject, controller, expected=wanted.turn, actual=actual.turn)
        return
    distance = wanted.ahead or wanted.left
    along, across = (actual.ahead, actual.left) if wanted.ahead else (actual.left, actual.ahead)
    way = "forward" if wanted.ahead else "to the left"
    expected = f"straight {way}"
    if not STRAIGHT[0] < along / distance < STRAIGHT[1]:
        expected, actual_way = f"{distance:.2g} m {way}", f"it moves by {along:+.3g} m"
    elif abs(across) > (STRAIGHT[1] - 1) * distance:
        actual_way = f"it also moves {'to the left' if wanted.ahead else 'forward'} by {across:+.2g} m"
    elif abs(actual.turn) > STRAIGHT_YAW:
        actual_way = f"it turns by {actual.turn:+.2g} rad"
    else:
        return
    yield trouble_of(does_not_drive_forward, subject, controller, expected=expected, actual=actual_way)
