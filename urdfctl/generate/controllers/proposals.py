"""Propose controllers for a robot: its chains with their tools, its drive, its sensors and its gpios."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import takewhile

from urdfctl.errors import UserError
from urdfctl.generate.controllers.fit import offered_by
from urdfctl.generate.options import GeneratorOptions, Request
from urdfctl.generate.robot.anatomy import Base, anatomy_of
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.generate.robot.hands import Tool
from urdfctl.generate.robot.name_words import SIDES, words_of

_SENSORS = {
    "force.x": "force_torque_broadcaster",
    "torque.x": "force_torque_broadcaster",
    "angular_velocity.x": "imu_broadcaster",
    "linear_acceleration.x": "imu_broadcaster",
    "latitude": "gps_broadcaster",
    "range": "range_broadcaster",
    "magnetic_field.x": "magnetometer_broadcaster",
    "position.x": "pose_broadcaster",
    "battery_voltage": "battery_broadcaster",
}
_PARTS = ("arm", "leg", "head", "neck", "torso", "waist", "lift", "hand", "pan", "tail", "wing", "mast")
_FINGERS = frozenset(("finger", "fingers", "thumb", "index", "middle", "ring", "pinky", "little", "knuckle"))
_FEET = 4
"""A robot with at least this many equal chains, of which nothing else is known, walks on them."""
_ARM = 3
"""A chain of at least this many joints is called an arm if nothing else is known of it."""
_LONG = 5
"""A chain of at least this many joints is no torso, lift or head because of one of them."""
_ONLY_ROS2 = ("mecanum", "omni", "bicycle", "tricycle", "tricycle_steering")


def proposed(robot: RobotFacts, joints: Sequence[JointFacts], options: GeneratorOptions) -> tuple[Request, ...]:
    """Return controllers for all parts of a robot that some joints form. UserError if one of them is unclear."""
    parts, offered = anatomy_of(robot, joints), offered_by(robot, options)
    found = [
        *(_of_base(parts.base, options, offered) if parts.base else ()),
        *_of_chains(parts.chains),
        *_of_tools(parts.tools, robot, offered),
        *(_of_sensors(robot) if options.ros == 2 else ()),  # noqa: PLR2004
    ]
    return tuple(numbered(_unlike(found, {joint.name for joint in robot.joints})))


def _unlike(requests: Sequence[Request], taken: Collection[str]) -> list[Request]:
    """The requests with names that no joint has: a controller of that name would hide the joint's interfaces."""
    return [
        one._replace(name=f"{one.name.removesuffix('_controller')}_motion_controller") if one.name in taken else one
        for one in requests
    ]


def with_interfaces(requests: Sequence[Request], interfaces: tuple[str, ...]) -> str:
    """Return proposals as options of a command line, with interfaces for those that can command several of a joint."""
    return shown(
        [one._replace(interfaces=interfaces) if one.type == "trajectory" else one for one in requests],
    )


def shown(requests: Sequence[Request]) -> str:
    """Return requests as options of a command line."""
    return " ".join(f"--controller {_shown_one(request)}" for request in requests)


def _shown_one(request: Request) -> str:
    joints = f":{','.join(request.patterns)}" if request.patterns else ""
    if not request.interfaces:
        return f"{request.name}={request.type}{joints}"
    return f"'{request.name}={request.type}[{','.join(request.interfaces)}]{joints}'"


def _of_base(base: Base, options: GeneratorOptions, offered: Mapping[str, tuple[str, ...]]) -> Iterator[Request]:
    if base.kind == "passive":
        return
    steering = {joint.name for joint in base.joints} & set(base.roles.steering)
    driven = [joint for joint in base.joints if joint.name not in steering]
    other = _other_than("velocity", driven, offered)
    if other:  # in ROS 1, velocity controllers also command efforts
        kind = "velocity" if options.ros == 1 and other == "effort" else other
        yield Request("wheel_controller", kind, tuple(joint.name for joint in base.joints))
        return
    here = {1: _ONLY_ROS2, 2: ("four_wheel_steering",)}[options.ros]
    if base.kind is None or base.kind in here:
        names = ", ".join(joint.name for joint in (*base.joints, *base.others)[:4])
        what = f"{options.distro} has no controller for {base.kind} bases" if base.kind else "its drive is unclear"
        raise UserError(f"no controller can be proposed for the wheels ({names}): {what}; use --controller NAME=TYPE")
    names_of = tuple(joint.name for joint in base.joints)
    yield Request("base_controller", base.kind, names_of, roles=base.roles if base.kind != "omni" else None)


def _of_chains(chains: Sequence[tuple[JointFacts, ...]]) -> Iterator[Request]:
    labels = [_label(chain) for chain in chains]
    unnamed = [
        chain for chain, label in zip(chains, labels, strict=True) if label == "arm" and not _names(chain, "arm")
    ]
    if len(unnamed) >= _FEET and len({len(chain) for chain in unnamed}) == 1:
        labels = ["leg" if chain in unnamed else label for chain, label in zip(chains, labels, strict=True)]
    for chain, label in zip(chains, labels, strict=True):
        prefix = _prefix(chain, label) if labels.count(label) > 1 else ""
        name = prefix if re.search(rf"(?:^|_){label}\d+_$", prefix) else f"{prefix}{label}_"
        yield Request(f"{name}controller", "trajectory", tuple(joint.name for joint in chain))


def _other_than(wanted: str, joints: Sequence[JointFacts], offered: Mapping[str, tuple[str, ...]]) -> str | None:
    """The interface that the robot has for some joints if one of them lacks the wanted one."""
    known = [offered[joint.name] for joint in joints if offered.get(joint.name)]
    return next((names[0] for names in known if wanted not in names), None)


def _of_tools(tools: Sequence[Tool], robot: RobotFacts, offered: Mapping[str, tuple[str, ...]]) -> Iterator[Request]:
    """Gripper controllers, or trajectory controllers where a joint does not offer the velocity that those read."""
    states = {part.name: part.states for part in robot.of_kind("joint")}
    for tool in tools:
        measured = all("velocity" in states.get(joint.name, ("velocity",)) for joint in tool.joints)
        prefix = _prefix(tool.joints, "gripper") if len(tools) > 1 else ""
        fits = _other_than("position", tool.joints, offered) in (None, "effort")
        kind = "gripper" if tool.single and fits and measured else "trajectory"
        yield Request(f"{prefix}gripper_controller", kind, tuple(joint.name for joint in tool.joints))


def _of_sensors(robot: RobotFacts) -> Iterator[Request]:
    sensors = [part for part in robot.parts if part.kind in ("sensor", "gpio", "joint")]
    for part in sensors:
        kind = next((kind for state, kind in _SENSORS.items() if state in part.states), None)
        if kind and (part.kind == "sensor" or kind == "battery_broadcaster"):
            name = re.sub(r"[^A-Za-z0-9]+", "_", part.name).strip("_")
            yield Request(f"{name}_broadcaster", kind, (part.name,))
    gpios = [part.name for part in robot.of_kind("gpio") if "battery_voltage" not in part.states]
    if gpios:
        yield Request("gpio_controller", "gpio", tuple(gpios))


def _label(chain: Sequence[JointFacts]) -> str:
    """What a chain is, from the words in the names of its joints and links."""
    words = [words_of(f"{joint.name} {joint.link or ''}") for joint in chain]
    if sum(not _FINGERS.isdisjoint(of_joint) for of_joint in words) > len(words) / 2:
        return "hand"
    bent = len(chain) >= _ARM and any(part in of_joint for of_joint in words for part in ("shoulder", "elbow", "wrist"))
    for part in ("leg", "arm") if bent else _PARTS:
        said = sum(part in of_joint for of_joint in words)
        if said and (part in ("leg", "arm") or len(chain) < _LONG or said > len(chain) / 2):
            return {"neck": "head", "pan": "head", "waist": "torso"}.get(part, part)
    if any(part in word for of_joint in words for word in of_joint for part in ("hip", "thigh", "calf", "knee")):
        return "leg"
    return "arm" if len(chain) >= _ARM else "joint"


def _names(chain: Sequence[JointFacts], part: str) -> bool:
    """Whether a joint of a chain is named after a part."""
    return any(part in word for joint in chain for word in words_of(f"{joint.name} {joint.link or ''}"))


def _side(chain: Sequence[JointFacts]) -> str:
    """The side that the names of all joints of a chain say, such as `left_`; empty if they do not agree."""
    of_joints = [{SIDES[word] for word in words_of(joint.name) if word in SIDES} for joint in chain]
    common = set.intersection(*of_joints) if of_joints else set()
    return common.pop() if len(common) == 1 else ""


def _prefix(chain: Sequence[JointFacts], label: str) -> str:
    """What the names of a chain's joints begin with, in words, such as `left_`."""
    first, last = min(joint.name for joint in chain), max(joint.name for joint in chain)
    common = "".join(a for a, _ in takewhile(lambda pair: pair[0] == pair[1], zip(first, last, strict=False)))
    whole = common if len(chain) == 1 else re.sub(r"[A-Za-z0-9]*$", "", common)
    words = re.split(r"[^A-Za-z0-9]+", whole)
    kept = [word for word in words if word and word.lower() not in (label, "joint", "finger", "j")]
    return "".join(f"{word.lower()}_" for word in kept[:2] if not word[0].isdigit()) or _side(chain)


def numbered(requests: Sequence[Request]) -> Iterator[Request]:
    """Yield the requests with unique names."""
    names = [request.name for request in requests]
    count: dict[str, int] = {}
    for request in requests:
        number = count[request.name] = count.get(request.name, 0) + 1
        stem, _, last = request.name.rpartition("_")
        yield request if names.count(request.name) == 1 else request._replace(name=f"{stem}_{number}_{last}")
