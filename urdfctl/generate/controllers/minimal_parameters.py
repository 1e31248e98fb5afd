"""The minimal parameters of a controller, with the robot's joints in place of the catalogue's examples."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import matching
from urdfctl.catalog.validators import problem
from urdfctl.catalog.values import elements
from urdfctl.control.parameters.minimal import minimal_parameters
from urdfctl.control.parameters.rules import breaches
from urdfctl.errors import UserError
from urdfctl.generate.controllers.values import TODO, Task
from urdfctl.generate.text.settings import WrittenParameter

_EXAMPLE = re.compile(r"joint(\d+)(?:/position)?")
_OF_JOINTS = {"position", "velocity", "effort", "acceleration"}


def minimal_settings(controller: ControllerType, task: Task) -> Iterator[WrittenParameter]:
    """Yield a setting for each required parameter. Names of joints are the robot's, other values are marked TODO."""
    minimal = minimal_parameters(controller)
    of_joints = _joint_parameters(controller)
    named = {name: _named(name, value, task, name in of_joints) for name, value in minimal.items()}
    wide = {name: _all(name, value, controller, task, of_joints) for name, value in named.items()}
    if any(breach.rule.severity == "error" for breach in breaches(controller, wide)):
        wide = named
    for name, value in wide.items():
        pattern, element = matching(name, controller.parameters) or (name, None)
        if element is None:
            yield WrittenParameter(pattern, tuple(name.split(".")), value, "" if name in of_joints else _todo())
            continue
        if element != "joint1":
            continue
        placeholder = pattern.partition("<")[2].partition(">")[0]
        for name_of_joint in elements(wide.get(placeholder)) or [joint.name for joint in task.joints]:
            path = tuple(str(name_of_joint) if part.startswith("<") else part for part in pattern.split("."))
            yield WrittenParameter(pattern, path, value, _todo())


def checked(setting: WrittenParameter, task: Task) -> WrittenParameter:
    """Return the setting if it names only the robot's joints. UserError if the robot has too few."""
    named = setting.value if isinstance(setting.value, list) else [setting.value]
    joints = {joint.name for joint in task.joints}
    if joints and any(isinstance(value, str) and _EXAMPLE.fullmatch(value) and value not in joints for value in named):
        raise UserError(f"'{task.kind}' requires more than {len(joints)} joint{'s' if len(joints) > 1 else ''}")
    return setting


def _joint_parameters(controller: ControllerType) -> set[str]:
    """The parameters that name joints, determined from the interfaces that the controller claims for them."""
    claims = controller.claims
    names = set(controller.joint_parameters)
    for rule in (*(claims.command if claims else ()), *(claims.state if claims else ())):
        plain = {interface.rpartition("/")[2] for interface in rule.interfaces}
        if plain <= _OF_JOINTS or any(interface.endswith("JointInterface") for interface in plain):
            names |= {name for name in (rule.for_each, rule.or_else) if name}
    return names


def _named(name: str, value: object, task: Task, joints: bool) -> object:  # noqa: FBT001
    """A value with joint1, joint2, ... replaced by the robot's joints."""
    if isinstance(value, list):
        return [_named(name, part, task, joints) for part in value]
    if not isinstance(value, str):
        return value
    example = _EXAMPLE.fullmatch(value)
    if example is None:
        return value
    if "frame" in name or name.endswith((".base", ".tip")):
        return task.robot.root or "base_link"
    index = int(example[1]) - 1
    if index < len(task.joints):
        return value.replace(f"joint{index + 1}", task.joints[index].name, 1)
    return value


def _all(name: str, value: object, controller: ControllerType, task: Task, of_joints: set[str]) -> object:
    """All joints if the parameter accepts a list of any length, else the value unchanged."""
    if name not in of_joints or not isinstance(value, list) or len(value) != 1:
        return value
    every = [joint.name for joint in task.joints]
    return every if every and problem(every, controller.parameters[name].validators) is None else value


def _todo() -> str:
    return f"{TODO}: set it"
