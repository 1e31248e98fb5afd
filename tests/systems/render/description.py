"""A robot's description: URDF, xacro with arguments, or a xacro file that calls macros of others."""

from __future__ import annotations

from dataclasses import replace
from textwrap import indent
from typing import NamedTuple

from systems.possible import Idioms
from systems.render.hardware import WEBOTS, hardware_of, plugin_of
from systems.render.places import (
    Places,
    config_folder,
    description_name,
    is_text,
    parameter_names,
    source_name,
)
from systems.system import GZ, Joint, Robot, System

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
FILE_ARGUMENTS = ("controllers_file", "types_file")
ADDRESS = "robot_ip"
"""The argument that has no value until somebody starts the robot."""
CHOICE = "use_sim"
"""The argument that chooses between a simulator and hardware."""
_DEFAULTS = {ADDRESS: "127.0.0.1", CHOICE: "false"}


def xacro_arguments(system: System, idioms: Idioms, robot: Robot) -> dict[str, str]:
    """Return the xacro arguments that a robot's description has to be given, with their values; "" for a path."""
    if is_text(idioms):
        return {}
    arguments = {"prefix": robot.prefix} if any(one.prefix for one in _sharing(system, robot)) else {}
    if idioms["address"] == "required":
        arguments[ADDRESS] = ""
    if idioms["hardware"] == "chosen":
        arguments[CHOICE] = str(system.is_simulated).lower()
    if not system.is_simulated:
        return arguments
    if any(one.namespace for one in _sharing(system, robot)):
        arguments["namespace"] = robot.namespace
    if system.generation == 2 and files_are_given(system, idioms):
        names = FILE_ARGUMENTS[: len(parameter_names(system, idioms, robot))]
        arguments |= dict.fromkeys(names, "")
    return arguments


def files_are_given(system: System, idioms: Idioms) -> bool:
    """Return whether the simulator's plugin has the path of its parameters from an argument."""
    return system.is_fleet or idioms["argued"] in ("controllers", "all")


def _sharing(system: System, robot: Robot) -> list[Robot]:
    return [one for one in system.robots if one.model == robot.model]


class _Words(NamedTuple):
    """How a description writes what depends on its arguments."""

    prefix: str
    namespace: str
    files: tuple[str, ...]


def descriptions(system: System, idioms: Idioms, places: Places) -> dict[str, str]:
    """Return the files of the descriptions by their paths in the workspace."""
    files: dict[str, str] = {}
    for robot in system.robots:
        name = source_name(system, idioms, robot)
        folder = f"{places.description}/urdf/"
        if folder + name in files:
            continue
        if idioms["source"] == "macros":
            files |= {folder + key: text for key, text in _with_macros(system, idioms, places, robot).items()}
        else:
            files[folder + name] = _whole(system, idioms, places, robot)
    return files


def _words(system: System, idioms: Idioms, places: Places, robot: Robot, form: str) -> _Words:
    """form: of an argument in the text, such as `$(arg {})`; the values themselves if it is not an argument."""
    given = xacro_arguments(system, idioms, robot)

    def word(name: str, value: str) -> str:
        return form.format(name) if name in given else value

    folder = f"$(find {places.control})/{config_folder(system)}"
    names = parameter_names(system, idioms, robot)
    order = [*names[-1:], *names[:-1]]  # the first argument is the file of the controllers
    files = tuple(word(argument, f"{folder}/{name}") for argument, name in zip(FILE_ARGUMENTS, order, strict=False))
    return _Words(word("prefix", robot.prefix), word("namespace", robot.namespace), files)


def _declared(system: System, idioms: Idioms, places: Places, robot: Robot) -> str:
    """The arguments with defaults that are not those of the robot, where that is possible."""
    lines = []
    names = parameter_names(system, idioms, robot)
    for name in xacro_arguments(system, idioms, robot):
        default = _DEFAULTS.get(name, "")
        if name in FILE_ARGUMENTS:
            file = [names[-1], *names[:-1]][FILE_ARGUMENTS.index(name)]
            default = f"$(find {places.control})/{config_folder(system)}/{file}"
        lines.append(f'<xacro:arg name="{name}" default="{default}"/>\n')
    if idioms["planner"] == "other arguments":
        lines.append('<xacro:arg name="planning" default="false"/>\n')
    if idioms["address"] == "required":
        lines.append(f'<xacro:property name="address" value="$(arg {ADDRESS})"/>\n')
    return "".join(lines)


def _planning(idioms: Idioms, robot: Robot, prefix: str) -> str:
    """What only the planner's description has."""
    if idioms["planner"] != "other arguments":
        return ""
    name, parent = f"{prefix}planning_frame", f"{prefix}{robot.joints[-1].name}_link"
    joint = f'  <parent link="{parent}"/>\n  <child link="{name}"/>\n'
    text = f'<link name="{name}"/>\n<joint name="{name}_fixed" type="fixed">\n{joint}</joint>\n'
    return f'<xacro:if value="$(arg planning)">\n{indent(text, "  ")}</xacro:if>\n'


def _whole(system: System, idioms: Idioms, places: Places, robot: Robot) -> str:
    words = _words(system, idioms, places, robot, "$(arg {})")
    if idioms["source"] == "urdf":
        return _document(robot, _body(system, idioms, robot, words), "")
    body = _declared(system, idioms, places, robot) + _body(system, idioms, robot, words)
    body += _planning(idioms, robot, words.prefix)
    return _document(robot, body, f" {XACRO}")


def _body(system: System, idioms: Idioms, robot: Robot, words: _Words) -> str:
    control = _hardware(system, idioms, robot, words.prefix)
    return _links(robot, words.prefix) + control + _plugin(system, idioms, robot, words)


def _hardware(system: System, idioms: Idioms, robot: Robot, prefix: str) -> str:
    if idioms["manager description"] == "webots":
        return WEBOTS + hardware_of(system, robot, prefix, in_webots=True)
    if idioms["hardware"] == "fixed":
        return hardware_of(system, robot, prefix)
    real, simulated = both(system)
    inside = indent(hardware_of(simulated, robot, prefix), "  ")
    other = indent(hardware_of(real, robot, prefix), "  ")
    value = f'value="$(arg {CHOICE})"'
    return f"<xacro:if {value}>\n{inside}</xacro:if>\n<xacro:unless {value}>\n{other}</xacro:unless>\n"


def _plugin(system: System, idioms: Idioms, robot: Robot, words: _Words) -> str:
    if idioms["hardware"] == "fixed":
        return plugin_of(system, robot, words.namespace, words.files)
    inside = indent(plugin_of(both(system)[1], robot, words.namespace, words.files), "  ")
    return f'<xacro:if value="$(arg {CHOICE})">\n{inside}</xacro:if>\n'


def both(system: System) -> tuple[System, System]:
    """Return the system on hardware and in a simulator: where an argument chooses."""
    return replace(system, simulator=""), system if system.is_simulated else replace(system, simulator=GZ)


def _document(robot: Robot, body: str, spaces: str) -> str:
    return f'<?xml version="1.0"?>\n<robot name="{robot.model}"{spaces}>\n{indent(body, "  ")}</robot>\n'


def _with_macros(system: System, idioms: Idioms, places: Places, robot: Robot) -> dict[str, str]:
    """The file that calls, and the files with the macros: of links and joints, and of the hardware."""
    words = _words(system, idioms, places, robot, "${{{}}}")
    inside = words._replace(prefix="${prefix}")
    main, model = description_name(system, idioms, robot), robot.model
    parts = {
        f"{model}_macro.xacro": (model, _links(robot, "${prefix}")),
        f"{model}.control.xacro": (f"{model}_control", _hardware(system, idioms, robot, "${prefix}")),
        f"{model}.gazebo.xacro": (f"{model}_gazebo", _plugin(system, idioms, robot, inside)),
    }
    parts = {name: part for name, part in parts.items() if part[1]}
    given = xacro_arguments(system, idioms, robot)
    params = ["prefix", *(name for name in given if name != "prefix")]
    values = [f'prefix="{"$(arg prefix)" if "prefix" in given else robot.prefix}"']
    values += [f'{name}="$(arg {name})"' for name in params[1:]]
    body = _declared(system, idioms, places, robot)
    body += "".join(f'<xacro:include filename="$(find {places.description})/urdf/{name}"/>\n' for name in parts)
    body += "".join(f"<xacro:{name} {' '.join(values)}/>\n" for name, _ in parts.values())
    body += _planning(idioms, robot, f"{'$(arg prefix)' if 'prefix' in given else robot.prefix}")
    macros = {
        file: f'<?xml version="1.0"?>\n<robot {XACRO}>\n  <xacro:macro name="{name}" params="{" ".join(params)}">\n'
        f"{indent(text, '    ')}  </xacro:macro>\n</robot>\n"
        for file, (name, text) in parts.items()
    }
    return {main: _document(robot, body, f" {XACRO}"), **macros}


# -- links and joints ---------------------------------------------------------------------------------------------

_INERTIA = '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>'


def _links(robot: Robot, prefix: str) -> str:
    wheeled = any(joint.kind == "continuous" for joint in robot.joints)
    root = "base_footprint" if wheeled else "world"
    text = f'<link name="{prefix}{root}"/>\n'
    text += (
        f'<joint name="{prefix}{root}_fixed" type="fixed">\n  <parent link="{prefix}{root}"/>\n'
        f'  <child link="{prefix}base_link"/>\n  <origin xyz="0 0 0.1"/>\n</joint>\n'
    )
    text += _link(f"{prefix}base_link", '<box size="0.4 0.3 0.1"/>', 6)
    for joint in robot.joints:
        shape = '<cylinder radius="0.1" length="0.04"/>' if joint.kind == "continuous" else '<box size="0.1 0.1 0.3"/>'
        text += _joint(joint, prefix) + _link(f"{prefix}{joint.name}_link", shape, 1)
    return text


def _link(name: str, shape: str, mass: float) -> str:
    shapes = "".join(f"  <{what}>\n    <geometry>{shape}</geometry>\n  </{what}>\n" for what in ("visual", "collision"))
    inertial = f'  <inertial>\n    <mass value="{mass}"/>\n    {_INERTIA}\n  </inertial>\n'
    return f'<link name="{name}">\n{shapes}{inertial}</link>\n'


def _joint(joint: Joint, prefix: str) -> str:
    parent = f"{joint.parent}_link" if joint.parent else "base_link"
    side = -1 if "right" in joint.name else 1
    place = f"0 {side * 0.2} 0" if joint.kind == "continuous" else "0 0 0.3"
    axis = "0 1 0" if joint.kind != "prismatic" else "0 0 1"
    limits = {
        "revolute": '<limit lower="-1.5" upper="1.5" effort="60" velocity="2"/>',
        "prismatic": '<limit lower="0" upper="0.04" effort="20" velocity="0.5"/>',
        "continuous": '<limit effort="20" velocity="20"/>',
    }
    return (
        f'<joint name="{prefix}{joint.name}" type="{joint.kind}">\n  <parent link="{prefix}{parent}"/>\n'
        f'  <child link="{prefix}{joint.name}_link"/>\n  <origin xyz="{place}"/>\n  <axis xyz="{axis}"/>\n'
        f"  {limits[joint.kind]}\n</joint>\n"
    )
