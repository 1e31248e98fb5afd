"""Read a launch file in XML that a migration wrote, and nobody changed since: its actions."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import takewhile

from urdfctl.generate.text.scalars import xml_text
from urdfctl.migrate.edits.markup import root_of
from urdfctl.migrate.launch.actions import (
    IN_PARENTHESES,
    Action,
    ActionCondition,
    PartOfText,
    Text,
    divided,
    words_of,
)
from urdfctl.migrate.launch.written import WrittenLaunch, as_xml
from urdfctl.source.span import SourceText
from urdfctl.source.todo import MARK
from urdfctl.source.xml.dom import COMMENT, Element, XmlNode, XmlText

_SUBSTITUTION = rf"\$\((var|find-pkg-share|env|dirname|eval)\s*({IN_PARENTHESES})\)"
_KINDS = {"arg": "argument", "let": "let", "set_parameter": "set_parameter", "include": "include", "node": "node"}
_FLAGS = ("output", "respawn", "launch-prefix", "shell")


def read_xml(source: SourceText) -> WrittenLaunch | None:
    """Return what a migration wrote into a launch file; None if it has any other form."""
    root = root_of(source)
    first = root.previousSibling if root is not None else None
    if root is None or not isinstance(first, XmlText) or first.nodeType != COMMENT:
        return None
    actions = tuple(_actions(root))
    todos = tuple(takewhile(lambda action: action.kind == "comment" and action.name.startswith(MARK), actions))
    shown = tuple(f"<!-- {todo.name} -->" for todo in todos)
    written = WrittenLaunch(first.data.strip(), shown, actions[len(todos) :])
    return written if as_xml(written).encode() == source.data else None


def _actions(parent: Element) -> Iterator[Action]:
    node: XmlNode | None = parent.firstChild
    while node is not None:
        if isinstance(node, XmlText) and node.nodeType == COMMENT:
            yield Action("comment", node.data.strip())
        elif isinstance(node, Element) and node.tagName != "push-ros-namespace":
            yield _action(node)
        node = node.nextSibling


def _action(element: Element) -> Action:
    attrs = element.attrs
    kind = _KINDS.get(element.tagName, "group")
    name, inner = attrs.get("name", ""), tuple(element.elements())
    action = Action(kind, name)
    if kind == "argument":
        default = _text(attrs["default"]) if "default" in attrs else None
        action = action._replace(value=default, about=attrs.get("description", ""))
    elif kind in ("let", "set_parameter"):
        action = action._replace(value=_text(attrs.get("value", "")))
    elif kind == "include":
        pairs = tuple((one.attrs.get("name", ""), _text(one.attrs.get("value", ""))) for one in inner)
        action = action._replace(value=_text(attrs.get("file", "")), pairs=pairs)
    elif kind == "node":
        action = _node(element)
    else:
        pushed = next((one for one in inner if one.tagName == "push-ros-namespace"), None)
        space = _text(pushed.attrs.get("namespace", "")) if pushed is not None else None
        action = action._replace(value=space, inner=tuple(_actions(element)))
    condition = next((each for each in ("if", "unless") if each in attrs), None)
    return action._replace(
        condition=ActionCondition(_text(attrs[condition]), condition == "unless") if condition else None
    )


def _node(element: Element) -> Action:
    attrs = element.attrs
    given = list(element.elements())
    parameters = [one.attrs for one in given if one.tagName == "param"]
    values = [one for one in parameters if "from" not in one]
    command = next((one["value"] for one in values if one.get("type") == "str"), "")
    flags = {name: value for name, value in attrs.items() if name in _FLAGS}
    return Action(
        "node",
        attrs.get("exec", ""),
        value=_text(attrs["namespace"]) if "namespace" in attrs else None,
        package=attrs.get("pkg", ""),
        node_name=_text(attrs.get("name", "")),
        words=words_of(_text(attrs.get("args", ""))),
        pairs=tuple((one.get("name", ""), _value(one)) for one in values if one.get("type") != "str"),
        files=tuple(_text(one["from"]) for one in parameters if "from" in one),
        description=_text(command.removeprefix("$(command '").removesuffix("' 'warn')").replace('"', "'")),
        remaps=tuple(_remap(one) for one in given if one.tagName == "remap"),
        flags=tuple((name.replace("launch-prefix", "prefix"), _flag(value)) for name, value in flags.items()),
    )


def _value(param: Mapping[str, str]) -> Text:
    value = _text(param.get("value", ""))
    return (PartOfText("double", ""), *value) if param.get("type") == "float" else value


def _remap(element: Element) -> tuple[Text, Text]:
    return _text(element.attrs.get("from", "")), _text(element.attrs.get("to", ""))


def _flag(value: str) -> str:
    return value.capitalize() if value in ("true", "false") else value


def _text(text: str) -> Text:
    return divided(text, _SUBSTITUTION, _part)


def _part(found: re.Match[str]) -> PartOfText:
    kind, inner = found[1], found[2].strip()
    if kind == "env":
        name, _, default = inner.partition(" ")
        return PartOfText("env", name, default.strip("'") if default else None)
    if kind == "eval":
        return PartOfText("written", xml_text(found[0]))
    return PartOfText({"var": "arg", "find-pkg-share": "find"}.get(kind, kind), inner)
