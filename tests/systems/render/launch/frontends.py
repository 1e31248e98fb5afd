"""Launch files of ROS 2 in XML and in YAML."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any
from xml.sax.saxutils import quoteattr

import yaml

from systems.render.actions import (
    Action,
    Arg,
    Description,
    Execute,
    Group,
    Include,
    LaunchFile,
    Node,
    Param,
    ParamFile,
    Share,
    Timer,
    Value,
    Variable,
    When,
)

FileNames = Callable[[str, str], str]
"""Return the name of a launch file of the workspace, by package and stem, with what its language adds."""
Tree = dict[str, Any]
_PUSH = {"humble": "push-ros-namespace"}


def written(file: LaunchFile, distro: str, names: FileNames) -> str:
    """Return the text of a launch file in XML or YAML."""
    entities = [_declaration(name, default, is_set=file.is_set) for name, default in file.declared]
    push = _PUSH.get(distro, "push_ros_namespace")
    for action in file.actions:
        entities += _entities(action, None, push, names)
    if file.language == "yaml":
        text: str = yaml.safe_dump({"launch": [_as_yaml(one) for one in entities]}, sort_keys=False, width=1000)
        return text
    return '<?xml version="1.0"?>\n<launch>\n' + "".join(_as_xml(one, "  ") for one in entities) + "</launch>\n"


def text_of(value: Value) -> str:
    """Return a value as XML and YAML launch files write it."""
    return "".join(_piece(piece) for piece in value)


def _piece(piece: object) -> str:
    if isinstance(piece, Arg):
        return f"$(var {piece.name})"
    if isinstance(piece, Variable):
        return f"$(env {piece.name} {piece.default})"
    if isinstance(piece, Share):
        return "/".join([f"$(find-pkg-share {text_of(piece.package)})", *map(text_of, piece.parts)])
    return str(piece)


Entity = tuple[str, Tree, list[Any]]
"""A tag with its attributes and its children."""


def _declaration(name: str, default: Value | None, *, is_set: bool) -> Entity:
    if is_set and default is not None:
        return "let", {"name": name, "value": text_of(default)}, []
    return ("arg", {"name": name} if default is None else {"name": name, "default": text_of(default)}, [])


def _entities(action: Action, when: When | None, push: str, names: FileNames) -> list[Entity]:
    if isinstance(action, Node):
        return [_node(action, action.when or when)]
    if isinstance(action, Execute):
        command = " ".join(text_of(word) for word in action.words)
        return [("executable", {"cmd": command, **_condition(action.when or when), "output": "screen"}, [])]
    if isinstance(action, Include):
        return [_include(action, when, names)]
    if isinstance(action, Timer):
        inside = [entity for each in action.actions for entity in _entities(each, when, push, names)]
        return [("timer", {"period": action.seconds}, inside)]
    if isinstance(action, Group):
        inside = [entity for each in action.actions for entity in _entities(each, action.when or when, push, names)]
        if not action.namespace:
            return inside
        return [("group", {}, [(push, {"namespace": text_of(action.namespace)}, []), *inside])]
    raise TypeError(f"{action} has no form in XML and YAML")


def _condition(when: When | None) -> Tree:
    if when is None:
        return {}
    if when.form == "expression":
        sign = "==" if when.holds else "!="
        return {"if": f"$(eval '\\'$(var {when.arg})\\' {sign} \\'{when.value}\\'')"}
    return {"if" if (when.value == "true") is when.holds else "unless": f"$(var {when.arg})"}


def _node(node: Node, when: When | None) -> Entity:
    attributes: Tree = {"pkg": node.package, "exec": node.executable}
    attributes |= {"name": node.name} if node.name else {}
    attributes |= {"namespace": text_of(node.namespace)} if node.namespace else {}
    attributes |= {"args": " ".join(map(text_of, node.arguments))} if node.arguments else {}
    attributes |= _condition(when)
    children: list[Entity] = [_parameter(parameter) for parameter in node.parameters]
    children += [("remap", {"from": before, "to": after}, []) for before, after in node.remaps]
    return "node", attributes, children


def _parameter(parameter: Param | ParamFile) -> Entity:
    if isinstance(parameter, ParamFile):
        return "param", {"from": text_of(parameter.path)}, []
    if isinstance(parameter.value, Description):
        return "param", {"name": parameter.name, "value": command_of(parameter.value), "type": "str"}, []
    value = parameter.value
    return "param", {"name": parameter.name, "value": str(value).lower() if isinstance(value, bool) else value}, []


def command_of(description: Description) -> str:
    """Return the substitution that makes the text of a description."""
    program = "cat" if description.is_plain else "xacro"
    words = [program, text_of(description.path), *(f"{name}:={text_of(value)}" for name, value in description.mappings)]
    return f"$(command '{' '.join(words)}')"


def _include(action: Include, when: When | None, names: FileNames) -> Entity:
    file = action.file if action.is_external else _own(action, names)
    attributes = {"file": f"$(find-pkg-share {action.package})/{file}", **_condition(when)}
    if action.path:
        attributes["file"] = text_of(action.path)
    return (
        "include",
        attributes,
        [("arg", {"name": name, "value": text_of(value)}, []) for name, value in action.arguments],
    )


def _own(action: Include, names: FileNames) -> str:
    return "" if action.path else f"launch/{names(action.package, action.file)}"


# -- the two syntaxes ---------------------------------------------------------------------------------------------


def _as_xml(entity: Entity, margin: str) -> str:
    tag, attributes, children = entity
    words = "".join(f" {name}={quoteattr(str(value))}" for name, value in attributes.items())
    if not children:
        return f"{margin}<{tag}{words}/>\n"
    inside = "".join(_as_xml(child, f"{margin}  ") for child in children)
    return f"{margin}<{tag}{words}>\n{inside}{margin}</{tag}>\n"


def _as_yaml(entity: Entity) -> Tree:
    tag, attributes, children = entity
    if tag == "group":
        return {tag: [_as_yaml(child) for child in children]}
    if tag == "timer":
        return {tag: {**attributes, "children": [_as_yaml(child) for child in children]}}
    inside: Tree = dict(attributes)
    for name, values, _ in children:
        inside.setdefault(name, []).append(values)
    return {tag: inside}
