"""Launch files of ROS 1."""

from __future__ import annotations

from textwrap import indent
from xml.sax.saxutils import escape, quoteattr

from systems.render.actions import (
    Action,
    Arg,
    Describe,
    Group,
    Include,
    LaunchFile,
    Load,
    Node,
    Param,
    Share,
    Value,
    Variable,
    When,
)
from systems.render.launch.frontends import FileNames
from systems.render.places import pick
from systems.system import System


def written(file: LaunchFile, system: System, names: FileNames) -> str:
    """Return the text of a launch file."""
    lines = [_declaration(name, default, is_set=file.is_set) for name, default in file.declared]
    lines += [_action(action, system, names) for action in file.actions]
    head = '<?xml version="1.0"?>\n' if pick(system, "declaration", (True, False)) else ""
    return f"{head}<launch>\n{indent(''.join(lines), '  ')}</launch>\n"


def text_of(value: Value) -> str:
    """Return a value as launch files of ROS 1 write it."""
    return "".join(_piece(piece) for piece in value)


def _piece(piece: object) -> str:
    if isinstance(piece, Arg):
        return f"$(arg {piece.name})"
    if isinstance(piece, Variable):
        return f"$(optenv {piece.name} {piece.default})"
    if isinstance(piece, Share):
        return "/".join([f"$(find {text_of(piece.package)})", *map(text_of, piece.parts)])
    return str(piece)


def _tag(tag: str, attributes: dict[str, str], inside: str = "") -> str:
    words = "".join(f" {name}={quoteattr(value)}" for name, value in attributes.items() if value)
    return f"<{tag}{words}>\n{indent(inside, '  ')}</{tag}>\n" if inside else f"<{tag}{words}/>\n"


def _declaration(name: str, default: Value | None, *, is_set: bool) -> str:
    if default is None:
        return f"<arg name={quoteattr(name)}/>\n"
    how = "value" if is_set else "default"
    return f"<arg name={quoteattr(name)} {how}={quoteattr(text_of(default))}/>\n"


def _action(action: Action, system: System, names: FileNames) -> str:
    if isinstance(action, Node):
        return _node(action)
    if isinstance(action, Describe):
        return _description(action, system)
    if isinstance(action, Load):
        return _load(action)
    if isinstance(action, Param):
        return _tag("param", {"name": action.name, "value": str(action.value).lower()})
    if isinstance(action, Include):
        return _include(action, names)
    if isinstance(action, Group):
        inside = "".join(_action(each, system, names) for each in action.actions)
        return _tag("group", {"ns": text_of(action.namespace), **_condition(action.when, system)}, inside)
    raise TypeError(f"{action} has no form in ROS 1")


def _condition(when: When | None, system: System) -> dict[str, str]:
    if when is None:
        return {}
    if when.form == "expression":
        sign = "==" if when.holds else "!="
        name = pick(system, "eval", (f"arg('{when.arg}')", when.arg))
        return {"if": f"$(eval {name} {sign} '{when.value}')"}
    return {"if" if (when.value == "true") is when.holds else "unless": f"$(arg {when.arg})"}


def _node(node: Node) -> str:
    arguments = " ".join(map(text_of, node.arguments))
    attributes = {"name": node.name, "pkg": node.package, "type": node.executable, "ns": text_of(node.namespace)}
    return _tag("node", {**attributes, "args": arguments})


def _description(action: Describe, system: System) -> str:
    found, name = action.description, text_of(action.name)
    path = text_of(found.path)
    if found.is_plain:
        how = pick(system, "plain description", ("textfile", "command"))
        return _tag("param", {"name": name, how: path if how == "textfile" else f"cat {path}"})
    program = pick(system, "xacro", ("$(find xacro)/xacro", "$(find xacro)/xacro --inorder", "xacro"))
    quote = pick(system, "quote", ("'", ""))
    words = [program, f"{quote}{path}{quote}", *(f"{key}:={text_of(value)}" for key, value in found.mappings)]
    return _tag("param", {"name": name, "command": " ".join(words)})


def _load(load: Load) -> str:
    attributes = {"ns": text_of(load.namespace)}
    if load.text:
        words = "".join(f" {name}={quoteattr(value)}" for name, value in attributes.items() if value)
        return f"<rosparam{words}>\n{escape(load.text)}</rosparam>\n"
    return _tag("rosparam", {"command": "load", "file": text_of(load.path), **attributes})


def _include(action: Include, names: FileNames) -> str:
    if action.path:
        return _tag("include", {"file": text_of(action.path)})
    file = action.file if action.is_external else f"launch/{names(action.package, action.file)}"
    inside = "".join(
        f"<arg name={quoteattr(name)} value={quoteattr(text_of(value))}/>\n" for name, value in action.arguments
    )
    return _tag("include", {"file": f"$(find {action.package})/{file}"}, inside)
