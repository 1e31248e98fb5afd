"""Generate a robot's model for MuJoCo: its bodies, an actuator for each commanded joint, mimic joints and sensors."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.control.claims import claims
from urdfctl.errors import UserError
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.options import File, GeneratorOptions
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.generate.robot.mounting import is_fixed
from urdfctl.generate.text.scalars import xml_text
from urdfctl.generate.text.templates import Templates
from urdfctl.startup.records import NamedTuple

_HERTZ = 5.0
"""The bandwidth of position and velocity actuators."""
_SAG = 0.002
"""The error, in rad or m, that the weight may cause with a position actuator."""
_IMU = {
    "orientation.": ("framequat", "_quat"),
    "angular_velocity.": ("gyro", "_gyro"),
    "linear_acceleration.": ("accelerometer", "_accel"),
}
_WRENCH = {"force.": ("force", "_force"), "torque.": ("torque", "_torque")}


MODEL = "mujoco/robot.xml"
"""The path of the model in a generated package."""


class Actuator(NamedTuple):
    """An actuator: its element, and its attributes as text."""

    element: str
    joint: str
    attributes: str


def commanded(made: Sequence[GeneratedController], robot: RobotFacts) -> dict[str, str]:
    """Return the command interface of each joint: from the controllers, or else from the robot."""
    found: dict[str, str] = {}
    for controller in made:
        claimed = claims(controller.type, controller.name, controller.values)
        for claim in claimed.command if claimed else ():
            found.setdefault(claim.component, claim.interface)
    known = {joint.name for joint in robot.joints}
    if not found:
        found = {name: names[0] for name, names in robot.interfaces.items() if names}
    return {name: interface for name, interface in found.items() if name in known}


def mjcf_file(
    robot: RobotFacts, interfaces: Mapping[str, str], options: GeneratorOptions, templates: Templates, name: str
) -> File:
    """Return the model. UserError if the robot's bodies are unknown.

    interfaces: the command interface of each joint that gets an actuator.
    """
    skeleton = robot.skeleton
    if skeleton is None:
        raise UserError("a model for MuJoCo requires a robot, not a list of joints")
    free = not is_fixed(robot, options)
    joints = {joint.name: joint for joint in robot.joints}
    meshes = [
        {"name": mesh, "file": _from(options.model_path, path), "scale": scale} for mesh, path, scale in skeleton.meshes
    ]
    text = templates.render(
        "mjcf/robot.xml",
        command=options.command,
        name=robot.name or "robot",
        meshes=meshes,
        surfaces=[
            {"name": mesh, "scale": scale, "corners": corners, "faces": faces}
            for mesh, scale, corners, faces in skeleton.surfaces
        ],
        bodies=skeleton.free if free else skeleton.fixed,
        mimics=list(_mimics(robot)),
        actuators=[_actuator(joints[joint], interface) for joint, interface in interfaces.items()],
        sensors=list(_sensors(robot)),
        notes=skeleton.notes,
        ground=min(0.0, robot.lowest or 0.0) if free else 0.0,
    )
    return File(name, _with_sites(text, robot))


def _from(model: str | None, path: str) -> str:
    """A mesh's path as the model at a path names it."""
    if model is None or not os.path.isabs(path):
        return path.replace(os.sep, "/")
    return os.path.relpath(path, os.path.abspath(os.path.dirname(model))).replace(os.sep, "/")


def _mimics(robot: RobotFacts) -> Iterator[dict[str, str]]:
    known = {joint.name for joint in robot.joints}
    for joint in robot.joints:
        if joint.mimic and joint.mimic[0] in known:
            leader, multiplier, offset = joint.mimic
            yield {"joint": joint.name, "leader": leader, "terms": f"{offset!r} {multiplier!r} 0 0 0"}


def _actuator(joint: JointFacts, interface: str) -> Actuator:
    """The actuator that takes what controllers command: a position, a velocity or an effort."""
    w, heavy = 2 * math.pi * _HERTZ, (joint.load.heaviest if joint.load else joint.inertia) or 0.01
    force = f' forcerange="{-joint.effort!r} {joint.effort!r}"' if joint.effort else ""
    if interface.startswith("position"):
        kp = max(heavy * w * w, (joint.load.gravity if joint.load else 0.0) / _SAG, joint.damping * w)
        limits = ""
        if joint.lower is not None and joint.upper is not None and joint.lower < joint.upper:
            limits = f' ctrlrange="{float(joint.lower)!r} {float(joint.upper)!r}"'
        kv = 2 * math.sqrt(kp * heavy)
        return Actuator("position", joint.name, f' kp="{kp:.4g}" kv="{kv:.4g}"{limits}{force}')
    if interface.startswith("velocity"):
        limits = f' ctrlrange="{-joint.velocity!r} {joint.velocity!r}"' if joint.velocity else ""
        return Actuator("velocity", joint.name, f' kv="{heavy * w:.4g}"{limits}{force}')
    limits = f' ctrlrange="{-joint.effort!r} {joint.effort!r}"' if joint.effort else ""
    return Actuator("motor", joint.name, limits)


def _sensors(robot: RobotFacts) -> Iterator[dict[str, str]]:
    """The sensors of a robot's `<ros2_control>`, as mujoco_ros2_control looks for them."""
    for part in robot.of_kind("sensor"):
        if part.name not in robot.sensor_links:
            continue
        for prefix, (element, suffix) in {**_IMU, **_WRENCH}.items():
            if any(state.startswith(prefix) for state in part.states):
                place = f'objtype="site" objname="{xml_text(_site(part.name))}"'
                place = place if element == "framequat" else f'site="{xml_text(_site(part.name))}"'
                yield {"element": element, "name": f"{part.name}{suffix}", "place": place}


def _site(sensor: str) -> str:
    return f"{sensor}_site"


def _with_sites(text: str, robot: RobotFacts) -> str:
    """The model with a site for each sensor, at the beginning of the body of its link."""
    for part in robot.of_kind("sensor"):
        link = robot.sensor_links.get(part.name)
        start = text.find(f'<body name="{xml_text(link)}"') if link else -1
        if start >= 0:
            end = text.index(">", start) + 1
            text = f'{text[:end]}\n      <site name="{xml_text(_site(part.name))}"/>{text[end:]}'
    return text
