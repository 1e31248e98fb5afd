"""What the generators need to know, taken from a robot's model."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.generate.facts import JointFacts, PartFacts, RobotFacts
from urdfctl.generate.frames import Measured, measured, root_of
from urdfctl.model.parts import Number
from urdfctl.model.robot import Joint, Robot

_MOVING = ("revolute", "continuous", "prismatic")
_UNEVEN = 0.1
"""How far above the lowest wheel, in radii, another one still touches the ground."""
_LEVEL = 0.3
"""The most of a wheel's axis that may stand upright: sin 17 deg."""


def facts_of(robot: Robot) -> RobotFacts:
    """The facts of a robot, without those of its files."""
    found = measured(robot)
    named = {joint.name: joint for joint in robot.joints if joint.name}
    moving = [_joint(name, joint, found.get(name)) for name, joint in named.items() if joint.type in _MOVING]
    mass = sum(link.inertials[0].mass.value or 0.0 for link in robot.links if link.inertials and link.inertials[0].mass)
    return RobotFacts(
        robot.name,
        root=root_of(robot),
        joints=tuple(_with_load(moving, mass)),
        fixed=tuple(name for name, joint in named.items() if joint.type not in _MOVING),
        interfaces=_interfaces(robot),
        parts=tuple(_parts(robot)),
        components=tuple(control.name or "" for control in robot.ros2_controls),
        hosts=tuple(plugin.filename for plugin in robot.plugins if plugin.filename),
    )


def _with_load(joints: list[JointFacts], mass: float) -> Iterator[JointFacts]:
    """The joints; wheels that stand on the ground move their share of the robot besides themselves."""
    rolling = [joint for joint in joints if joint.type == "continuous" and joint.radius and joint.at and _lies(joint)]
    ground = min((_bottom(wheel) for wheel in rolling), default=0.0)
    wheels = [wheel for wheel in rolling if _bottom(wheel) - ground < _UNEVEN * (wheel.radius or 0.0)]
    for joint in joints:
        if joint in wheels and len(wheels) > 1 and mass:
            share = mass / len(wheels) * (joint.radius or 0.0) ** 2
            yield joint._replace(inertia=(joint.inertia or 0.0) + share)
        else:
            yield joint


def _lies(joint: JointFacts) -> bool:
    return joint.axis is not None and abs(joint.axis[2]) < _LEVEL


def _bottom(wheel: JointFacts) -> float:
    return (wheel.at or (0.0, 0.0, 0.0))[2] - (wheel.radius or 0.0)


def _parts(robot: Robot) -> Iterator[PartFacts]:
    for control in robot.ros2_controls:
        for kind in ("joint", "sensor", "gpio"):
            for part in control.of_kind(kind):
                commands, states = (
                    tuple(one.name for one in side if one.name) for side in (part.commands, part.states)
                )
                yield PartFacts(kind, part.name or "", commands, states)


def _joint(name: str, joint: Joint, found: Measured | None) -> JointFacts:
    limit = joint.limit
    lower, upper = (_value(limit.lower), _value(limit.upper)) if limit and joint.type != "continuous" else (None, None)
    return JointFacts(
        name,
        joint.type or "",
        joint.mimic is not None,
        lower,
        upper,
        _value(limit.effort) if limit else None,
        _value(limit.velocity) if limit else None,
        found.at if found else None,
        found.axis if found else None,
        found.radius if found else None,
        found.inertia if found else None,
        link=joint.child.name if joint.child else None,
    )


def _value(number: Number | None) -> float | None:
    return number.value if number else None


def _interfaces(robot: Robot) -> dict[str, tuple[str, ...]]:
    """The command interfaces that joints have: of ROS 2 by name, of ROS 1 by their type's first word."""
    found: dict[str, list[str]] = {}
    for transmission in robot.transmissions:
        for end in transmission.kept_joints:
            names = [one.value.removeprefix("hardware_interface/") for one in end.named_interfaces]
            plain = [name.removesuffix("JointInterface").lower() for name in names]
            found.setdefault(end.name or "", []).extend(plain)
    for control in robot.ros2_controls:
        for part in control.of_kind("joint"):
            found.setdefault(part.name or "", []).extend(one.name for one in part.commands if one.name)
    return {joint: tuple(dict.fromkeys(names)) for joint, names in found.items()}
