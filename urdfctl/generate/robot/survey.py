"""Collect the facts that the generators need from a robot's model."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.generate.robot.facts import JointFacts, Load, PartFacts, RobotFacts
from urdfctl.generate.robot.frames import Measured, axis_of, frames_of, measured, number_of, root_of
from urdfctl.generate.robot.loads import loads_of
from urdfctl.generate.robot.mounting import lowest_of
from urdfctl.generate.robot.rims import Corners, no_corners, rim_of
from urdfctl.model.geometry import Pose
from urdfctl.model.robot import Joint, Number, Robot
from urdfctl.source.span import Place

_MOVING = ("revolute", "continuous", "prismatic")
_MADE, _HEADER = b"made by urdfctl gen-%s ", 2048
_UNEVEN = 0.1
"""The greatest height above the lowest wheel, in radii, at which another wheel still touches the ground."""
_LEVEL = 0.3
"""The greatest vertical component of a wheel's axis: sin 17 deg."""


def facts_of(robot: Robot, corners: Corners = no_corners) -> RobotFacts:
    """Return the facts of a robot, except those of its files. `corners` reads the meshes of wheels."""
    measurements = measured(robot)
    named = {joint.name: joint for joint in robot.joints if joint.name}
    moving = [_joint(name, joint, measurements.get(name)) for name, joint in named.items() if joint.type in _MOVING]
    moving = list(_with_rims(robot, moving, corners))
    above = _moving_above(robot)
    moving = [joint._replace(above=above.get(joint.name)) for joint in moving]
    loads = loads_of(robot, moving)
    moving = [joint._replace(load=loads.get(joint.name)) for joint in moving]
    mass = sum(link.inertials[0].mass.value or 0.0 for link in robot.links if link.inertials and link.inertials[0].mass)
    return RobotFacts(
        robot.name,
        root=root_of(robot),
        joints=tuple(_with_load(moving, mass)),
        fixed=tuple(name for name, joint in named.items() if joint.type not in _MOVING),
        interfaces=_interfaces(robot),
        parts=tuple(_parts(robot)),
        components=tuple(control.name or "" for control in robot.ros2_controls),
        plugins=tuple(control.plugin for control in robot.ros2_controls if control.plugin),
        hosts=tuple(plugin.filename for plugin in robot.plugins if plugin.filename),
        hosted=tuple(dict.fromkeys(_hosted(robot))),
        space=next(_spaces(robot), ""),
        sensor_links=_sensor_links(robot),
        generated=tuple(_generated(robot)),
        lowest=lowest_of(robot),
        mesh_packages=tuple(dict.fromkeys(_mesh_packages(robot))),
    )


def _hosted(robot: Robot) -> Iterator[str]:
    """The parameter files that the plugins of a robot load."""
    for plugin in robot.plugins:
        for setting in plugin.tag.named("parameters") if "control" in (plugin.filename or "") else ():
            if setting.text.strip():
                yield setting.text.strip()


def _spaces(robot: Robot) -> Iterator[str]:
    """The namespaces, but the root, that plugins of ROS 1 and ROS 2 give their controller managers."""
    for plugin in robot.plugins:
        if "control" in (plugin.filename or ""):
            inner = (tag for ros in plugin.tag.named("ros") for tag in ros.named("namespace"))
            for tag in (*plugin.tag.named("robotNamespace"), *inner):
                yield from filter(None, [tag.text.strip().strip("/")])


def _with_rims(robot: Robot, joints: list[JointFacts], corners: Corners) -> Iterator[JointFacts]:
    """The joints with the radius and the middle of the wheel that each turns."""
    frames, links = frames_of(robot), {link.name: link for link in robot.links}
    named = {joint.name: joint for joint in robot.joints}
    for facts in joints:
        joint, frame = named[facts.name], frames.get(facts.link or "")
        rim = rim_of(joint, links.get(facts.link), axis_of(joint, Pose()), corners)
        yield facts._replace(radius=rim.radius, middle=frame.at(rim.middle)) if rim and frame else facts


def _mesh_packages(robot: Robot) -> Iterator[str]:
    for mesh in robot.meshes:
        scheme, found, path = mesh.filename.partition("://")
        if found and scheme in ("package", "model"):
            yield path.partition("/")[0]


def _generated(robot: Robot) -> Iterator[str]:
    """What generators wrote, and will replace: components with their parts, and the joints of transmissions."""
    for control in robot.ros2_controls:
        if _is_made(control.tag.at, b"ros2-control"):
            yield control.name or ""
            yield from (part.name or "" for kind in ("joint", "sensor", "gpio") for part in control.of_kind(kind))
    for transmission in robot.transmissions:
        if _is_made(transmission.at, b"transmissions"):
            yield from (end.name or "" for end in transmission.kept_joints)


def _is_made(at: Place, generator: bytes) -> bool:
    """Whether a generator wrote an element: its name is at the beginning of the file, or just above."""
    data, start, made = at.source.data, at.start, _MADE % generator
    return made in data[:_HEADER] or made in data[max(0, start - _HEADER // 2) : start]


def _moving_above(robot: Robot) -> dict[str, str]:
    """The next joint towards the root that moves, for each joint."""
    by_child = {joint.child.name: joint for joint in robot.joints if joint.child and joint.child.name}
    found: dict[str, str] = {}
    for joint in robot.joints:
        seen: set[str] = set()
        upper = by_child.get(joint.parent.name or "") if joint.parent else None
        while upper and upper.name and upper.name not in seen and upper.type not in _MOVING:
            seen.add(upper.name)
            upper = by_child.get(upper.parent.name or "") if upper.parent else None
        if joint.name and upper and upper.name and upper.type in _MOVING and upper.name != joint.name:
            found[joint.name] = upper.name
    return found


def _sensor_links(robot: Robot) -> dict[str, str]:
    """The link of each sensor: where Gazebo mounts it, or else the link that has its name."""
    links = {link.name for link in robot.links if link.name}
    mounted = {
        tag.attributes.get("name", ""): gazebo.reference
        for gazebo in robot.gazebos
        if gazebo.reference in links
        for tag in gazebo.tag.named("sensor")
    }
    names = [part.name or "" for control in robot.ros2_controls for part in control.of_kind("sensor")]
    for name in names:
        plain = name.removesuffix("_sensor")
        near = (name, f"{name}_link", f"{name}_frame", plain, f"{plain}_link", f"{plain}_frame", f"{plain}_sensor_link")
        link = mounted.get(name) or next((link for link in near if link in links), None)
        if link:
            mounted[name] = link
    return {name: link for name, link in mounted.items() if name and link}


def _with_load(joints: list[JointFacts], mass: float) -> Iterator[JointFacts]:
    """The joints with their load. Wheels on the ground also move their share of the robot's mass."""
    rolling = [joint for joint in joints if joint.type == "continuous" and joint.radius and joint.at and _lies(joint)]
    ground = min((_bottom(wheel) for wheel in rolling), default=0.0)
    wheels = [wheel for wheel in rolling if _bottom(wheel) - ground < _UNEVEN * (wheel.radius or 0.0)]
    for joint in joints:
        if joint in wheels and len(wheels) > 1 and mass:
            share = mass / len(wheels) * (joint.radius or 0.0) ** 2
            inertia = (joint.inertia or 0.0) + share
            yield joint._replace(inertia=inertia, load=Load(0.0, inertia, joint.inertia or inertia))
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
                    tuple(interface.name for interface in side if interface.name)
                    for side in (part.commands, part.states)
                )
                yield PartFacts(kind, part.name or "", commands, states)


def _joint(name: str, joint: Joint, measurement: Measured | None) -> JointFacts:
    limit = joint.limit
    lower, upper = (_value(limit.lower), _value(limit.upper)) if limit and joint.type != "continuous" else (None, None)
    return JointFacts(
        name=name,
        type=joint.type or "",
        mimics=joint.mimic is not None,
        mimic=_followed(joint),
        lower=lower,
        upper=upper,
        effort=_value(limit.effort) if limit else None,
        velocity=_value(limit.velocity) if limit else None,
        at=measurement.at if measurement else None,
        axis=measurement.axis if measurement else None,
        inertia=measurement.inertia if measurement else None,
        link=joint.child.name if joint.child else None,
        damping=_dynamics(joint, "damping"),
        friction=_dynamics(joint, "friction"),
        macro=next((call.name for call in joint.at.call.chain() if call.kind == "macro"), "") if joint.at.call else "",
    )


def _followed(joint: Joint) -> tuple[str, float, float] | None:
    if joint.mimic is None or not joint.mimic.joint:
        return None
    multiplier, offset = _value(joint.mimic.multiplier), _value(joint.mimic.offset)
    return joint.mimic.joint, 1.0 if multiplier is None else multiplier, offset or 0.0


def _dynamics(joint: Joint, name: str) -> float:
    """A value of `<dynamics>`; 0 if there is none, or if it is not a number."""
    dynamics = next(joint.tag.named("dynamics"), None)
    return max(0.0, number_of(dynamics.attributes.get(name)) or 0.0) if dynamics else 0.0


def _value(number: Number | None) -> float | None:
    return number.value if number else None


def _interfaces(robot: Robot) -> dict[str, tuple[str, ...]]:
    """The command interfaces of the joints. For ROS 1, the first word of the interface's type, e.g. `effort`."""
    interfaces: dict[str, list[str]] = {}
    for transmission in robot.transmissions:
        for end in transmission.kept_joints:
            names = [interface.value.removeprefix("hardware_interface/") for interface in end.named_interfaces]
            plain = [name.removesuffix("JointInterface").lower() for name in names]
            interfaces.setdefault(end.name or "", []).extend(plain)
    for control in robot.ros2_controls:
        for part in control.of_kind("joint"):
            commands = [command.name for command in part.commands if command.name]
            interfaces.setdefault(part.name or "", []).extend(commands)
    return {joint: tuple(dict.fromkeys(names)) for joint, names in interfaces.items()}
