"""The parameters of controllers and their manager, as YAML."""

from __future__ import annotations

from typing import Any

import yaml

from systems.possible import Idioms
from systems.system import BROADCASTER, DRIVE, FORWARD, TRAJECTORY, Controller, Robot, System, type_of

Tree = dict[str, Any]
RATE = 100
"""Of the manager."""


def parameter_files(system: System, idioms: Idioms, robot: Robot, names: tuple[str, ...]) -> dict[str, str]:
    """Return a robot's files of parameters by their names: the manager's first if it has its own."""
    if not names:
        return {}
    if system.generation == 1:
        sections = _ros1_sections(system, idioms, robot)
        half = len(sections) // 2 if len(names) > 1 else 0
        parts = [dict(list(sections.items())[:half]), dict(list(sections.items())[half:])][-len(names) :]
        return {name: dumped(_below(idioms, robot, part)) for name, part in zip(names, parts, strict=True)}
    manager = _section(system, idioms, robot, robot.manager, manager_parameters(system, idioms, robot))
    own: Tree = {}
    for controller in robot.controllers:
        if parameters := own_parameters(system, robot, controller):
            own |= _section(system, idioms, robot, controller.name, parameters)
    if idioms["sections"] == "nested":
        manager, own = _nested(robot, manager), _nested(robot, own)
    if len(names) > 1:
        return {names[0]: dumped(manager), names[1]: dumped(own)}
    if idioms["parameters"] == "written":
        text = dumped(_merged(manager, own))
        return {names[0]: text.replace(f"update_rate: {RATE}", "update_rate: @rate@")}
    return {names[0]: dumped(_merged(manager, own))}


def dumped(tree: Tree) -> str:
    """Return YAML as people write it: in order, lists of names on one line."""
    text: str = yaml.safe_dump(tree, sort_keys=False, default_flow_style=None, width=100)
    return text


def _merged(first: Tree, second: Tree) -> Tree:
    merged = {**first}
    for key, value in second.items():
        merged[key] = {**merged[key], **value} if isinstance(merged.get(key), dict) else value
    return merged


def _section(system: System, idioms: Idioms, robot: Robot, node: str, parameters: Tree) -> Tree:
    """A node's section. The name of the section is as the switch says."""
    form = idioms["sections"]
    inside = {"ros__parameters": parameters}
    if form in {"nested", "rewritten"}:
        return {node: inside}
    if form == "replaced":
        return {f"<robot_namespace>/{node}": inside}
    if form == "wildcard":
        return {f"/**/{node}": inside}
    if robot.section:
        return {f"/{robot.section}/{node}": inside}
    return {f"/{node}" if form == "rooted" else node: inside}


def _nested(robot: Robot, sections: Tree) -> Tree:
    return {robot.section: sections}


def types_of(system: System, robot: Robot) -> Tree:
    """Return the types of a robot's controllers, as the manager's parameters have them."""
    return {one.name: {"type": type_of(one, 2)} if one.typed else {"update_rate": 50} for one in robot.controllers}


def manager_parameters(system: System, idioms: Idioms, robot: Robot) -> Tree:
    """Return the parameters of a ROS 2 controller manager in a file."""
    parameters: Tree = {"update_rate": RATE}
    if system.is_simulated:
        parameters["use_sim_time"] = True
    return parameters if idioms["parameters"] == "dictionary" else {**parameters, **types_of(system, robot)}


def own_parameters(system: System, robot: Robot, controller: Controller) -> Tree:
    """Return the parameters of a controller itself, in ROS 2; in ROS 1 also its type."""
    joints = [f"{robot.prefix}{name}" for name in controller.joints]
    first = system.generation == 1
    if controller.family == BROADCASTER:
        return {"publish_rate": 50} if first else {}
    if controller.family == DRIVE:
        return _drive(joints, robot.prefix, first=first)
    if controller.family == TRAJECTORY:
        return _trajectory(controller, joints, first=first)
    if controller.family == FORWARD:
        return {"joint": joints[0]} if first else {"joints": joints, "interface_name": controller.interface}
    return {"joints": joints}


def _trajectory(controller: Controller, joints: list[str], *, first: bool) -> Tree:
    found: Tree = {"joints": joints}
    if not first:
        found |= {"command_interfaces": [controller.interface], "state_interfaces": ["position", "velocity"]}
    if controller.interface != "position":
        found["gains"] = {joint: {"p": 100.0, "i": 0.1, "d": 1.0} for joint in joints}
    return found


def _drive(joints: list[str], prefix: str, *, first: bool) -> Tree:
    if first:
        return {
            "left_wheel": joints[0],
            "right_wheel": joints[1],
            "wheel_separation": 0.4,
            "wheel_radius": 0.1,
            "publish_rate": 50,
            "base_frame_id": f"{prefix}base_footprint",
            "pose_covariance_diagonal": [0.001, 0.001, 1000000.0, 1000000.0, 1000000.0, 1000.0],
            "twist_covariance_diagonal": [0.001, 0.001, 1000000.0, 1000000.0, 1000000.0, 1000.0],
        }
    return {
        "left_wheel_names": joints[:1],
        "right_wheel_names": joints[1:],
        "wheel_separation": 0.4,
        "wheel_radius": 0.1,
        "base_frame_id": f"{prefix}base_footprint",
    }


# -- ROS 1 --------------------------------------------------------------------------------------------------------


def _ros1_sections(system: System, idioms: Idioms, robot: Robot) -> Tree:
    sections: Tree = {}
    for controller in robot.controllers:
        head = {"type": type_of(controller, 1)} if controller.typed else {}
        sections[controller.name] = {**head, **own_parameters(system, robot, controller)}
    return sections


def inline_parameters(system: System, idioms: Idioms, robot: Robot) -> str:
    """Return the parameters as they stand in a launch file of ROS 1."""
    return dumped(_below(idioms, robot, _ros1_sections(system, idioms, robot)))


def _below(idioms: Idioms, robot: Robot, sections: Tree) -> Tree:
    """Below the namespace if it is a key of the file, or in the keys of the file."""
    if robot.section and idioms["loading"] == "full names":
        return {f"/{robot.section}/{name}": section for name, section in sections.items()}
    return {robot.section: sections} if robot.section and idioms["loading"] == "key" else sections
