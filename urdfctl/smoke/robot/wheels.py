"""The wheels of a mobile base: where each is, about which axis it turns, and how well it grips the ground."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.model.geometry import Pose, Vector, minus, plus, scaled, transposed, turned
from urdfctl.smoke.robot.mechanism import Hinge, Mechanism
from urdfctl.startup.records import NamedTuple

LATERAL = 0.7
"""A wheel that drives forward has at least this much of its axis pointing sideways."""
LEVEL = 0.005
"""Wheels whose lowest points differ by at most this, in m, stand on the same ground."""
SLIDES, GRIPS = 0.1, 1.0
"""The friction on the ground of parts that slide, like casters, and of wheels, if the description gives none. The
ground has the friction 1, and the lower one of two surfaces counts, as in ODE."""


class Wheel(NamedTuple):
    """A wheel in the frame of the base: its joint, its axis, and the middle of its rim, in m."""

    hinge: Hinge
    axis: Vector
    place: Vector


def wheels_of(mechanism: Mechanism, names: Sequence[str], base_name: str) -> list[Wheel]:
    """Return the wheels with some joint names, in a base frame; in that of the root if it does not exist."""
    poses = mechanism.poses(mechanism.start())
    base = poses.get(base_name, poses[mechanism.root])
    back = transposed(base.turn)
    wheels = []
    for hinge in (mechanism.hinge(name) for name in names):
        if hinge is not None:
            pose = Pose(turned(back, minus(poses[hinge.child].place, base.place)))
            pose = pose.then(Pose(turn=back)).then(Pose(turn=poses[hinge.child].turn))
            axis = turned(pose.turn, hinge.axis)
            place = plus(pose.place, scaled(axis, mechanism.bodies[hinge.child].aside))
            wheels.append(Wheel(hinge, axis, place))
    return wheels


def is_wheel(mechanism: Mechanism, wheel: Wheel) -> bool:
    """Return whether a joint and its link look like a wheel that rolls forward or backward."""
    radius = mechanism.bodies[wheel.hinge.child].radius
    return wheel.hinge.type == "continuous" and abs(wheel.axis[1]) >= LATERAL and bool(radius)


def friction_of(given: float | None, *, is_wheel: bool) -> float:
    """Return the friction of a part on the ground, given that of the description."""
    return min(GRIPS, given) if given is not None else GRIPS if is_wheel else SLIDES
