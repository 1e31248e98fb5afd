"""The mechanism of a robot description: its links and joints, and what `<ros2_control>` and `<gazebo>` say of them."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator

from urdfctl.model.geometry import Pose, Rotation, Vector, of_angles, product, transposed, unit
from urdfctl.model.robot import ComponentPart, Joint, Link, Number, Robot, Tag, leading_number
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism

_MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def mechanism_of(robot: Robot) -> Mechanism | None:
    """Return the mechanism of a robot description, or None if its links do not form a tree with one root."""
    names = [link.name for link in robot.links if link.name]
    hinges = hinges_of(robot)
    children = [hinge.child for hinge in hinges]
    roots = [name for name in names if name not in children]
    unique = len(set(names)) == len(names) and len(set(children)) == len(children)
    if len(roots) != 1 or not unique or len({hinge.name for hinge in hinges}) != len(hinges):
        return None
    ordered = _ordered(roots[0], hinges)
    if len(ordered) != len(names) - 1 or {roots[0], *(hinge.child for hinge in ordered)} != set(names):
        return None
    floating = set(weightless(robot))
    grips = dict(grips_of(robot))
    bodies = {
        link.name: _body(link, falls=link.name not in floating)._replace(grip=grips.get(link.name))
        for link in robot.links
        if link.name
    }
    return Mechanism(roots[0], bodies, tuple(ordered))


def hinges_of(robot: Robot) -> list[Hinge]:
    """Return the hinges of a robot description in its order, also if they form no tree."""
    controls = _controls(robot)
    return [hinge for joint in robot.joints if (hinge := _hinge(joint, controls.get(joint.name or ""))) is not None]


def _ordered(root: str, hinges: list[Hinge]) -> list[Hinge]:
    by_parent: dict[str, list[Hinge]] = {}
    for hinge in hinges:
        by_parent.setdefault(hinge.parent, []).append(hinge)
    ordered: list[Hinge] = []
    pending = [root]
    while pending:
        here = by_parent.pop(pending.pop(0), [])
        ordered += here
        pending += [hinge.child for hinge in here]
    return ordered


def _controls(robot: Robot) -> dict[str, ComponentPart]:
    """The joints of `<ros2_control>` by name."""
    return {
        part.name: part for whole in robot.ros2_controls for part in whole.parts if part.kind == "joint" and part.name
    }


def _hinge(joint: Joint, control: ComponentPart | None) -> Hinge | None:
    parent, child = joint.parent, joint.child
    if not (joint.name and joint.type and parent and parent.name and child and child.name):
        return None
    limit, mimic = joint.limit, joint.mimic
    dynamics = next(joint.tag.named("dynamics"), None)
    return Hinge(
        name=joint.name,
        type=joint.type,
        parent=parent.name,
        child=child.name,
        pose=origin_of(joint.tag),
        axis=unit(numbers_of(joint.axis.text if joint.axis else "1 0 0")),
        lower=_number(limit.lower, 0.0) if limit else None,
        upper=_number(limit.upper, 0.0) if limit else None,
        effort=_number(limit.effort) if limit else None,
        velocity=_number(limit.velocity) if limit else None,
        damping=_resistance(dynamics, "damping"),
        friction=_resistance(dynamics, "friction"),
        mimic=(mimic.joint, _number(mimic.multiplier, 1.0) or 0.0, _number(mimic.offset, 0.0) or 0.0)
        if mimic and mimic.joint
        else None,
        ranges=tuple(_ranges(control)) if control else (),
        initial=_initial(control) if control else None,
        soft=_soft(next(joint.tag.named("safety_controller"), None)),
    )


def _soft(safety: Tag | None) -> tuple[float, float] | None:
    """The soft limits, 0 where they are not given."""
    if safety is None:
        return None
    low, high = (_float(safety.attributes.get(name, "0"), 0.0) for name in ("soft_lower_limit", "soft_upper_limit"))
    return low, high


def _resistance(dynamics: Tag | None, name: str) -> float:
    value = _float(dynamics.attributes.get(name, "0"), 0.0) if dynamics else 0.0
    return value if 0 < value < math.inf else 0.0


def _ranges(control: ComponentPart) -> Iterator[tuple[str, float, float]]:
    for interface in control.interfaces:
        given = [interface.parameter(name) for name in ("min", "max")]
        least, most = (_float(parameter.value, math.nan) if parameter else math.nan for parameter in given)
        if interface.kind == "command" and interface.name and least <= most:
            yield interface.name, least, most


def _initial(control: ComponentPart) -> float | None:
    """The initial position: that of the position interfaces, the state's before the command's."""
    named = [interface for interface in control.interfaces if interface.name == "position"]
    for interface in sorted(named, key=lambda interface: interface.kind != "state"):
        given = interface.parameter("initial_value")
        value = _float(given.value, math.nan) if given else math.nan
        if math.isfinite(value):
            return value
    return None


def _body(link: Link, *, falls: bool) -> LinkBody:
    name = link.name or ""
    radii = (_radius(geometry.role, geometry.shape) for geometry in link.geometries)
    radius = next((radius for radius in radii if radius is not None), None)
    if not link.inertials:
        return LinkBody(name, radius=radius, falls=falls)
    inertial = link.inertials[0]
    tag = next(link.tag.named("inertial"), None)
    origin = origin_of(tag) if tag else Pose()
    given = {key: _number(value, 0.0) or 0.0 for key, value in (inertial.inertia or {}).items()}
    xx, xy, xz, yy, yz, zz = (given.get(key, 0.0) for key in _MOMENTS)
    own: Rotation = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    inertia = product(product(origin.turn, own), transposed(origin.turn))
    return LinkBody(
        name=name,
        mass=_number(inertial.mass, 0.0) or 0.0,
        centre=origin.place,
        inertia=inertia,
        radius=radius,
        falls=falls,
    )


def _radius(role: str, shape: Tag | None) -> float | None:
    if role != "collision" or shape is None or shape.name not in ("cylinder", "sphere"):
        return None
    return _float(shape.attributes.get("radius", ""), math.nan)


def origin_of(tag: Tag) -> Pose:
    """Return the pose that the `<origin>` in an element gives."""
    origin = next(tag.named("origin"), None)
    if origin is None:
        return Pose()
    return Pose(
        numbers_of(origin.attributes.get("xyz", "0 0 0")), of_angles(*numbers_of(origin.attributes.get("rpy", "0 0 0")))
    )


def numbers_of(text: str) -> Vector:
    """Return the first three numbers of a text, filled up with 0."""
    numbers = [_float(part, 0.0) for part in text.split()[:3]]
    x, y, z = (*numbers, 0.0, 0.0, 0.0)[:3]
    return x, y, z


def _number(number: Number | None, default: float | None = None) -> float | None:
    return default if number is None else _float(number.text, math.nan)


def _float(text: str, default: float) -> float:
    """A number as C++ reads it, including `nan` and `inf`."""
    return (
        float(text)
        if re.fullmatch(r"\s*[+-]?(\d+\.?\d*([eE][+-]?\d+)?|\.\d+([eE][+-]?\d+)?|nan|inf)\s*", text, re.IGNORECASE)
        else default
    )


# -- what <gazebo> says of links -------------------------------------------------------------------------------------


def weightless(robot: Robot) -> Iterator[str]:
    """Yield the links whose gravity is turned off in Gazebo."""
    for gazebo in robot.gazebos:
        for tag in (*gazebo.tag.named("turnGravityOff"), *gazebo.tag.named("gravity")):
            off = ("true", "1") if tag.name == "turnGravityOff" else ("false", "0")
            if gazebo.reference and tag.text.strip().lower() in off:
                yield gazebo.reference


def grips_of(robot: Robot) -> Iterator[tuple[str, float]]:
    """Yield the links with a friction coefficient: that in the direction in which they have less.

    sdformat's parser_urdf.cc takes `<mu1>`, `<mu2>` and `<fdir1>` in `<gazebo>`, and a `<surface>` in a `<collision>`
    there. Without `<fdir1>` the two directions are those of the world (ODE's dPlaneSpace), so that a base that drives
    in both needs both. With it, one is for rolling, and the other one may be 0.
    """
    for gazebo in robot.gazebos:
        for place, first, second in (([gazebo.tag], "mu1", "mu2"), (_surfaces(gazebo.tag), "mu", "mu2")):
            found = [number for name in (first, second) for tag in place for number in _numbers_in(tag.named(name))]
            turned = any(any(tag.named("fdir1")) for tag in place)
            if gazebo.reference and found:
                yield gazebo.reference, max(found) if turned else min(found)


def _surfaces(gazebo: Tag) -> list[Tag]:
    """The elements that hold the friction of collision geometry."""
    tags = [gazebo]
    for name in ("collision", "surface", "friction", "ode"):
        tags = [child for tag in tags for child in tag.named(name)]
    return tags


def _numbers_in(tags: Iterable[Tag]) -> Iterator[float]:
    """The numbers of elements, as their texts or as their attributes `value`."""
    for tag in tags:
        number = leading_number(tag.attributes.get("value", tag.text).strip())
        if number is not None and math.isfinite(number):
            yield max(0.0, number)
