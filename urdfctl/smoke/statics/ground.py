"""The checks of a base on the ground, by formula: it stands on its wheels, and they grip well enough to drive it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.model.geometry import Vector
from urdfctl.rules.smoke.base_leans import base_leans
from urdfctl.rules.smoke.base_without_mass import base_without_mass
from urdfctl.rules.smoke.robot_tips_over import robot_tips_over
from urdfctl.rules.smoke.wheel_off_the_ground import wheel_off_the_ground
from urdfctl.rules.smoke.wheels_slip import wheels_slip
from urdfctl.smoke.results import ROBOT, Trouble, trouble_of
from urdfctl.smoke.robot import (
    GRAVITY,
    TIPPED,
    TOUCHING,
    Hinge,
    Mechanism,
    Shapes,
    friction_of,
    heights_of,
    rest_pose_of,
)
from urdfctl.smoke.statics.efforts import TIME
from urdfctl.smoke.tasks import ControllerTask, speed_of, suspended_wheels

MOST_LEANING = math.radians(6)
"""A base that leans farther than this at rest does not stand as it was built."""
_LITTLE = 1e-9
"""What is added to the spread of contacts along each axis, in m²."""


def ground_troubles(mechanism: Mechanism, shapes: Shapes, tasks: Sequence[ControllerTask]) -> Iterator[Trouble]:
    """Yield what is wrong with how a robot with driven wheels stands."""
    drives = [task for task in tasks if task.base]
    if not drives:
        return
    yield from _base(mechanism, shapes)
    wheels = {name: task.controller for task in reversed(drives) for name in task.driven_joints}
    hinges = [hinge for hinge in mechanism.hinges if hinge.name in wheels]
    bare = [hinge for hinge in hinges if not shapes.known.get(hinge.child) and hinge.child not in shapes.unknown]
    for hinge in bare:
        yield _lifted(hinge.name, wheels[hinge.name], ())
    is_stiff = shapes.complete and not suspended_wheels(mechanism, tasks)
    at_rest = rest_pose_of(mechanism, shapes) if is_stiff else None
    if at_rest is None or bare:
        return
    if at_rest.tilt > TIPPED:
        roll, pitch = math.atan2(at_rest.turn[2][1], at_rest.turn[2][2]), -math.asin(at_rest.turn[2][0])
        notes = ("check that it has enough wheels or casters",)
        yield trouble_of(robot_tips_over, ROBOT, None, notes, when=" at spawn", roll=roll, pitch=pitch)
        return
    lifted = [hinge for hinge in hinges if at_rest.heights.get(hinge.child, 0.0) > TOUCHING]
    for hinge in lifted:
        yield _lifted(hinge.name, wheels[hinge.name], tuple(at_rest.contacts))
    if at_rest.tilt > MOST_LEANING and not lifted:
        on = tuple(name for name in at_rest.contacts if name not in {hinge.child for hinge in hinges})
        high, height = _highest(heights_of(mechanism, shapes), at_rest.contacts)
        fields = {"on": on, "high": high, "height": f"{height:.2g}"}
        subject, repair = _repair_of_leaning(high, height, hinges, mechanism)
        yield trouble_of(base_leans, subject, None, repair, degrees=math.degrees(at_rest.tilt), **fields)
    if not lifted:
        yield from traction_troubles(mechanism, at_rest.contacts, tasks)


def _repair_of_leaning(
    high: Sequence[str], height: float, wheels: Sequence[Hinge], mechanism: Mechanism
) -> tuple[str, tuple[str, ...]]:
    """Return the joint at which the part is mounted that makes a robot lean, and what to change there."""
    mounts = [hinge for hinge in mechanism.hinges if hinge.child in high and hinge not in wheels]
    if len(mounts) != len(high) or height <= TOUCHING:
        return ROBOT, ("check that a caster or another wheel carries the base on this side",)
    others = f", and likewise joint '{mounts[1].name}'" if mounts[1:] else ""
    return f"joint:{mounts[0].name}", (f"lower its <origin> by {height:.2g} m, or enlarge the part{others}",)


def _highest(heights: Mapping[str, float], on: Iterable[str]) -> tuple[tuple[str, ...], float]:
    """The links of those on which a robot leans that are mounted highest, and how high above the lowest part, in m."""
    height = max(heights[name] for name in on)
    return tuple(name for name in on if heights[name] > height - TOUCHING), height


def _lifted(joint: str, controller: str, on: Sequence[str]) -> Trouble:
    return trouble_of(wheel_off_the_ground, f"joint:{joint}", controller, joint=joint, on=on)


def _base(mechanism: Mechanism, shapes: Shapes) -> Iterator[Trouble]:
    """The largest part of a robot's base must have a mass."""
    rigid = mechanism.body_of(mechanism.root)
    volumes = {name: sum(shape.volume for shape in shapes.known.get(name, ())) for name in rigid}
    largest = max(volumes, key=volumes.__getitem__)
    if volumes[largest] > 0 and not mechanism.bodies[largest].mass:
        rest = sum(mechanism.bodies[name].mass for name in rigid)
        yield trouble_of(base_without_mass, f"link:{largest}", None, (), link=largest, rest=f"{rest:.3g}")


# -- traction --------------------------------------------------------------------------------------------------------


def shares_of(places: Sequence[Vector]) -> list[float]:
    """Return the share of the weight that each contact carries, given their places from the centre of mass, in m.

    They add up to 1, and their moments cancel. Of more than three contacts the shares are a linear function of the
    place, as on equal springs under a stiff robot; a contact that would have to pull carries nothing.
    """
    carrying = list(range(len(places)))
    while carrying:
        shares = _balanced([places[n] for n in carrying])
        if min(shares) >= 0:
            return [shares[carrying.index(n)] if n in carrying else 0.0 for n in range(len(places))]
        carrying.pop(min(range(len(shares)), key=shares.__getitem__))
    return []


def _balanced(places: Sequence[Vector]) -> list[float]:
    """Shares a + b x + c y whose sum is 1 and whose moments are 0; contacts on a line or in a point balance what they
    can."""
    n = len(places)
    x0, y0 = (sum(place[axis] for place in places) / n for axis in range(2))
    offsets = [(place[0] - x0, place[1] - y0) for place in places]
    xx, xy, yy = (sum(a[i] * a[j] for a in offsets) for i, j in ((0, 0), (0, 1), (1, 1)))
    xx, yy = xx + _LITTLE, yy + _LITTLE
    determinant = xx * yy - xy * xy
    b, c = (xy * y0 - yy * x0) / determinant, (xy * x0 - xx * y0) / determinant
    return [1 / n + b * x + c * y for x, y in offsets]


def traction_troubles(
    mechanism: Mechanism, contacts: Mapping[str, Sequence[Vector]], tasks: Sequence[ControllerTask]
) -> Iterator[Trouble]:
    """Yield the bases whose wheels slip: they cannot drag what slides, and accelerate the robot, without it.

    `contacts` holds the points in which links touch the ground, from the centre of mass, in m.
    """
    places = [_middle(points) for points in contacts.values()]
    weight = -GRAVITY[2] * sum(body.mass for body in mechanism.bodies.values())
    loads = {name: share * weight for name, share in zip(contacts, shares_of(places), strict=True)}
    for task in tasks:
        drive = task.drive
        hinges = [hinge for name in drive.wheels if (hinge := mechanism.hinge(name))] if drive else []
        if not drive or not hinges:
            continue
        wheels = {hinge.child for hinge in hinges}
        thrust = sum(_friction(mechanism, name, load) for name, load in loads.items() if name in wheels)
        drags = {
            name: _friction(mechanism, name, loads[name], slides=True) for name in loads if _drags(mechanism, name)
        }
        needed = weight / -GRAVITY[2] * speed_of(drive, hinges) / TIME
        if thrust >= sum(drags.values()) + needed:
            continue
        fields = {"thrust": f"{thrust:.2g}", "needed": f"{sum(drags.values()) + needed:.2g}"}
        notes = [f"link '{name}' is dragged with {drag:.2g} N" for name, drag in drags.items() if drag > needed]
        low = [name for name in wheels if (grip := mechanism.bodies[name].grip) is not None and grip < 1]
        notes += [f"<gazebo> gives link '{name}' the friction {mechanism.bodies[name].grip:g}" for name in sorted(low)]
        yield trouble_of(wheels_slip, f"controller:{task.controller}", task.controller, tuple(notes), **fields)


def _middle(points: Sequence[Vector]) -> Vector:
    x, y, z = (sum(values) / len(points) for values in zip(*points, strict=True))
    return x, y, z


def _friction(mechanism: Mechanism, name: str, load: float, *, slides: bool = False) -> float:
    """The greatest force of a contact along the ground, in N."""
    return load * friction_of(mechanism.bodies[name].grip, is_wheel=not slides)


def _drags(mechanism: Mechanism, name: str) -> bool:
    """Whether a link slides on the ground when the robot drives: no joint without limits lets it roll."""
    return not any(hinge.type == "continuous" for hinge in mechanism.above(name))
