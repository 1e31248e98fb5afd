"""What can be written at a place: names that exist, types of this distro, parameters with a value of their type."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.catalog.map_parameters import expanded
from urdfctl.control.minimal import minimal_parameters
from urdfctl.control.session import Configured, session_of
from urdfctl.load.loader import LoadedTarget
from urdfctl.server.hover import described_parameter
from urdfctl.server.names import CONTROLLER, JOINT, LINK, names_in
from urdfctl.server.question import Question
from urdfctl.server.xacro_names import ARGUMENT, MACRO, PARAMETER, PROPERTY
from urdfctl.source.files import is_yaml
from urdfctl.startup.records import NamedTuple

_ATTRIBUTES = r"(?:\s+[\w:.-]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*"
_OPEN_ATTRIBUTE = rf"<(?P<tag>[\w:.-]+){_ATTRIBUTES}\s+(?P<name>[\w:.-]+)\s*=\s*[\"'][^\"']*$"
_OPEN_CALL = rf"<xacro:(?P<macro>[\w-]+){_ATTRIBUTES}\s+\w*$"
_KINDS = {
    ("parent", "link"): LINK, ("child", "link"): LINK, ("mimic", "joint"): JOINT, ("gazebo", "reference"): LINK,
    ("chain", "base_link"): LINK, ("chain", "tip_link"): LINK, ("passive_joint", "name"): JOINT,
    ("disable_collisions", "link1"): LINK, ("disable_collisions", "link2"): LINK,
}  # fmt: skip
_NAMES_JOINTS = {"ros2_control", "transmission", "group", "group_state"}
_INTERFACES = {"command_interface", "state_interface"}


class Item(NamedTuple):
    """Something that can be written at a place.

    kind: what it is: link, joint, controller, type, parameter, value, interface, macro, property, argument or package.
    text: what is inserted for the word before the place.
    about: what is known about it, as Markdown.
    """

    text: str
    kind: str
    about: str = ""


def items_at(question: Question) -> list[Item]:
    """Return what can be written at a place, without repeats."""
    if not question.robots:
        return []
    of_file = _in_yaml(question) if is_yaml(question.file) else _in_xml(question)
    return list({(item.text, item.kind): item for item in of_file}.values())


# -- XML -------------------------------------------------------------------------------------------------------------


def _in_xml(question: Question) -> Iterator[Item]:
    before = question.source.data[: question.offset].decode("utf-8", "replace")
    before = before[before.rfind("<") :] if "<" in before else ""
    if re.search(r"\$\(find\s+[\w.-]*$", before):
        yield from _packages(question)
    elif re.search(r"\$\(arg\s+[\w.-]*$", before):
        yield from _named(question, ARGUMENT)
    elif re.search(r"\$\{[^{}]*$", before):
        yield from _named(question, PROPERTY, PARAMETER)
    elif re.fullmatch(r"<(?:xacro:)?[\w-]*", before):
        yield from (Item(f"xacro:{item.text}", MACRO) for item in _named(question, MACRO))
    elif opened := re.match(_OPEN_ATTRIBUTE, before):
        yield from _in_attribute(question, opened["tag"], opened["name"])
    elif called := re.match(_OPEN_CALL, before):
        names = names_in(question.robots[0])
        parameters = (name.text for name in names if name.kind == PARAMETER and name.scope == called["macro"])
        yield from (Item(f'{text}=""', PARAMETER) for text in dict.fromkeys(parameters))


def _in_attribute(question: Question, tag: str, attribute: str) -> Iterator[Item]:
    if (tag, attribute) in _KINDS:
        yield from _named(question, _KINDS[tag, attribute])
    elif (tag, attribute) == ("joint", "name") and _parent(question) in _NAMES_JOINTS:
        yield from _named(question, JOINT)
    elif tag in _INTERFACES and attribute == "name":
        for robot in question.robots:
            for distro in robot.project.distros[-1:]:
                names = robot.project.catalog.standard_interfaces(robot.project.distro or distro)
                yield from (Item(name, "interface") for name in names)


def _parent(question: Question) -> str:
    """The tag of the element that is open before the place."""
    text = question.source.data[: question.offset].decode("utf-8", "replace")
    text = re.sub(r"<!--.*?(-->|$)", "", text[: text.rfind("<")], flags=re.DOTALL)
    open_tags: list[str] = []
    for found in re.finditer(r"<(/?)([\w:.-]+)(?:[^<>\"']|\"[^\"]*\"|'[^']*')*?(/?)>", text):
        if found[1]:
            if found[2] in open_tags:
                del open_tags[len(open_tags) - 1 - open_tags[::-1].index(found[2]) :]
        elif not found[3]:
            open_tags.append(found[2])
    return open_tags[-1] if open_tags else ""


def _packages(question: Question) -> Iterator[Item]:
    folder = os.path.dirname(question.file)
    seen: set[str] = set()
    for robot in question.robots:
        for source in robot.sources.values():
            found = re.findall(rb"\$\(find\s+([\w.-]+)\)", source.data)
            seen.update(name.decode() for name in found)
    yield from (Item(name, "package") for name in sorted(seen | {_own_package(folder)} - {""}))


def _own_package(folder: str) -> str:
    from urdfctl.source.packages import package_around, package_name

    package = package_around(folder)
    return (package_name(os.path.join(package, "package.xml")) if package else None) or ""


def _named(question: Question, *kinds: str) -> Iterator[Item]:
    for robot in question.robots:
        for name in names_in(robot):
            if name.kind in kinds and name.defines and name.text and "\ue000" not in name.text:
                yield Item(name.text, name.kind)


# -- YAML ------------------------------------------------------------------------------------------------------------


def _in_yaml(question: Question) -> Iterator[Item]:
    line = question.before
    keys = _keys_above(question)
    if re.match(r"\s*(?:- )?type:\s*[\w/]*$", line):
        for robot in question.robots:
            yield from _types(robot)
    elif re.match(r"\s*-\s*[\w/]*$", line) or "[" in line:
        key = keys[-1] if keys else line.partition(":")[0].strip()
        if "interface" in key:
            yield from _interfaces(question)
        else:
            yield from _named(question, *((CONTROLLER,) if "controller" in key else (JOINT,)))
    elif re.match(r"\s*[\w.]*$", line):
        yield from _parameters(question, keys)
    elif ":" in line:
        key = line.partition(":")[0].strip()
        yield from _named(question, LINK if "frame" in key or "link" in key else JOINT)


def _types(robot: LoadedTarget) -> Iterator[Item]:
    project = robot.project
    if project.distros:
        distro = project.distro or project.distros[-1]
        yield from (
            Item(name, "type", f"a controller type of {distro}") for name in project.catalog.known_types(distro)
        )


def _interfaces(question: Question) -> Iterator[Item]:
    for robot in question.robots:
        for component in robot.project.robot.ros2_controls if robot.project.robot else ():
            for part in component.parts:
                yield from (Item(each.name, "interface") for each in part.interfaces if each.name)


def _keys_above(question: Question) -> list[str]:
    """The keys of the maps around a line, the outermost first."""
    indent = len(question.before) - len(question.before.lstrip())
    keys: list[str] = []
    for number in range(question.line - 1, 0, -1):
        text = question.source.line(number)
        found = re.match(r"(\s*)(?:- )?([^\s#:][^:#]*):(?:\s|$)", text)
        is_list = question.before.lstrip().startswith("-")
        if found and (len(found[1]) < indent or (is_list and len(found[1]) == indent and not keys)):
            indent = len(found[1])
            keys.insert(0, found[2].strip().strip("\"'"))
    return keys


def _parameters(question: Question, keys: list[str]) -> Iterator[Item]:
    for robot in question.robots:
        project = robot.project
        if not project.distros or project.controllers is None:
            continue
        distro = project.distro or project.distros[-1]
        for each in session_of(project, distro).controllers:
            if each.name in [key.rpartition("/")[2] for key in keys]:
                yield from _of_controller(each, keys, distro, _commanded(robot))


def _commanded(robot: LoadedTarget) -> list[str]:
    """The joints that hardware commands, or that move if nothing is known of hardware."""
    model = robot.project.robot
    if model is None:
        return []
    parts = [part for component in model.ros2_controls for part in component.of_kind("joint") if part.commands]
    moving = [joint.name for joint in model.joints if joint.moves and joint.name and not joint.mimic]
    return [part.name for part in parts if part.name] or moving


def _of_controller(each: Configured, keys: list[str], distro: str, joints: list[str]) -> Iterator[Item]:
    """The parameters that a controller does not have yet, below the keys that are written already.

    joints: what a parameter that lists joints is offered with.
    """
    if each.type is None:
        return
    names = [key.rpartition("/")[2] for key in keys]
    inside = [key for key in keys[names.index(each.name) + 1 :] if key != "ros__parameters"]
    prefix = ".".join(inside) + "." if inside else ""
    examples = minimal_parameters(each.type)
    for name, parameter in each.type.parameters.items():
        if parameter.ignored or parameter.deprecated or parameter.type == "none":
            continue
        for full in expanded(name, each.values):
            rest = full.removeprefix(prefix)
            if full.startswith(prefix) and "." not in rest and full not in each.values:
                value = examples.get(name, parameter.default)
                if name in ("joints", *each.type.joint_parameters) and parameter.type == "string_array":
                    value = joints
                about = described_parameter(parameter, full, f"{each.type.type} ({distro})")
                yield Item(f"{rest}: {_written(value)}".rstrip(), PARAMETER, about)


def _written(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list | tuple):
        return f"[{', '.join(_written(one) for one in value)}]"
    if isinstance(value, str):
        return f'"{value}"' if not value or not re.fullmatch(r"[A-Za-z_][\w/-]*", value) else value
    return "" if value is None else str(value)
