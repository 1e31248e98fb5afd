"""What `<gazebo reference="link">` says of a link: its friction on the ground, and whether it has weight."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from urdfctl.model.parts import Tag, leading_number
from urdfctl.model.robot import Robot


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
            found = [number for name in (first, second) for tag in place for number in _numbers(tag.named(name))]
            turned = any(any(tag.named("fdir1")) for tag in place)
            if gazebo.reference and found:
                yield gazebo.reference, max(found) if turned else min(found)


def _surfaces(gazebo: Tag) -> list[Tag]:
    """The elements that hold the friction of collision geometry."""
    tags = [gazebo]
    for name in ("collision", "surface", "friction", "ode"):
        tags = [child for tag in tags for child in tag.named(name)]
    return tags


def _numbers(tags: Iterable[Tag]) -> Iterator[float]:
    """The numbers of elements, as their texts or as their attributes `value`."""
    for tag in tags:
        number = leading_number(tag.attributes.get("value", tag.text).strip())
        if number is not None and math.isfinite(number):
            yield max(0.0, number)
