"""The parameters that a launch file of ROS 1 gives to a node, with their names and types in ROS 2."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator

from urdfctl.generate.text.scalars import yaml_text
from urdfctl.migrate.edits.markup import elements, written_in
from urdfctl.migrate.launch.actions import PartOfText, Text, is_literal, parsed, plain
from urdfctl.source.span import SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, read_yaml

_NUMBER = re.compile(r"[+-]?\d+(\.\d*)?([eE][+-]?\d+)?")
_NO_STRING = re.compile(r"(?i)true|false|[+-]?\d+(\.\d*)?([eE][+-]?\d+)?")


def parameters_of(node: Element) -> Iterator[tuple[str, Text]]:
    """Yield the names and values of a node's `<param>` and `<rosparam>` with a value, in order."""
    for child in node.elements():
        if child.tagName == "param" and "value" in child.attrs:
            yield parameter_name(child.attrs.get("name", "")), value_of(child)
        elif child.tagName == "rosparam" and "file" not in child.attrs:
            names = (parameter_name(child.attrs.get(name, "")) for name in ("ns", "param"))
            yield from inline_parameters(child, ".".join(filter(None, names)))


def unread_parameters_of(node: Element) -> Iterator[str]:
    """Yield the names of a node's parameters that have no value in ROS 2: the text of a file or the output of a
    command, and what is no valid YAML."""
    for child in node.elements():
        if child.tagName == "param" and "value" not in child.attrs:
            yield parameter_name(child.attrs.get("name", ""))
        elif child.tagName == "rosparam" and "file" not in child.attrs and not any(inline_parameters(child, "it")):
            yield parameter_name(child.attrs.get("param", ""))


def parameter_name(name: str) -> str:
    """Return the name of a parameter in ROS 2, whose parts are separated by dots."""
    return name.strip("~/").replace("/", ".")


def value_of(param: Element) -> Text:
    """Return the value of a `<param>`, of the type that it names."""
    value, kind = parsed(param.attrs.get("value", "")), param.attrs.get("type", "")
    text = plain(value).strip()
    if not is_literal(value):
        return value
    if kind in ("str", "string") and _NO_STRING.fullmatch(text):
        return (PartOfText("yaml", yaml_text(text)),)
    if kind == "double" and re.fullmatch(r"[+-]?\d+", text):
        return (PartOfText("yaml", f"{text}.0"),)
    return (PartOfText("yaml", text),) if kind == "yaml" and text.startswith("[") else value


def inline_parameters(element: Element, name: str) -> Iterator[tuple[str, Text]]:
    """Yield the parameters that are written in a `<rosparam>`, below a name; nested maps add parts to it."""
    text = textwrap.dedent(written_in(element))
    for root in read_yaml(SourceText("", text.encode("utf-8", "surrogateescape"))).documents:
        yield from _leaves(root, name)


def _leaves(node: Node, name: str) -> Iterator[tuple[str, Text]]:
    if isinstance(node, Mapping):
        for entry in node.entries:
            yield from _leaves(entry.value, ".".join(filter(None, (name, parameter_name(entry.key.text)))))
    elif isinstance(node, Sequence):
        if node.items and name and all(isinstance(item, Scalar) for item in node.items):
            text = f"[{', '.join(_items(node))}]"
            yield name, parsed(text) if "$(" in text else (PartOfText("yaml", text),)
    elif name and node.text:
        is_text = bool(node.style) and _NO_STRING.fullmatch(node.text)
        yield name, (PartOfText("yaml", yaml_text(node.text)),) if is_text else parsed(node.text)


def _items(node: Sequence) -> Iterator[str]:
    """The elements of a list, which have one type in ROS 2: doubles if one is a double, strings if one is no number."""
    scalars = [item for item in node.items if isinstance(item, Scalar)]
    texts = [item.text for item in scalars]
    if all(text.lower() in ("true", "false") for text in texts):
        yield from (text.lower() for text in texts)
    elif all(_NUMBER.fullmatch(text) for text in texts) and not any(item.style for item in scalars):
        is_whole = all(re.fullmatch(r"[+-]?\d+", text) for text in texts)
        yield from (text if is_whole else str(float(text)) for text in texts)
    else:
        yield from map(yaml_text, texts)


def given_by_name(root: Element) -> list[tuple[Element, Element, str]]:
    """Return the parameters of a launch file that are set outside of a node, below the name of one of its nodes.

    Each is the node, the `<param>` or `<rosparam>`, and the name of the parameter in the node; empty if it is the node.
    """
    every = list(elements(root))
    nodes = {_full_name(one): one for one in every if one.tagName == "node" and one.attrs.get("name")}
    found = []
    for one in every:
        is_inside = any(outer.tagName == "node" for outer in around(one))
        if one.tagName not in ("param", "rosparam") or is_inside or {"if", "unless"} & one.attrs.keys():
            continue
        name = _full_name(one)
        owner = next((full for full in nodes if name == full or name.startswith(f"{full}/")), None)
        if owner is not None and (name != owner or one.tagName == "rosparam"):
            found.append((nodes[owner], one, name[len(owner) + 1 :]))
    return found


def namespace_of(element: Element) -> str:
    """Return the namespace of a node or include, or the full name of a parameter, without the slash before."""
    return _full_name(element, "" if element.tagName in ("node", "include") else None)


def space_beyond(node: Element, other: Element) -> str:
    """Return the namespace of a node, absolute; empty if the groups around another element have it too."""
    space = namespace_of(node)
    return f"/{space}" if space and space != space_around(other) else ""


def space_around(element: Element) -> str:
    """Return the namespace of the groups around an element, without the slash before."""
    spaces = (one.attrs.get("ns", "").strip("/") for one in reversed(list(around(element))))
    return "/".join(filter(None, spaces))


def _full_name(element: Element, named: str | None = None) -> str:
    own = element.attrs.get("param" if element.tagName == "rosparam" else "name", "") if named is None else named
    if own.startswith("/"):
        return own.strip("/")
    spaces = [outer.attrs.get("ns", "") for outer in reversed(list(around(element)))]
    return "/".join(part.strip("/") for part in (*spaces, element.attrs.get("ns", ""), own) if part.strip("/"))


def around(element: Element) -> Iterator[Element]:
    """Yield the elements around another one, from the inside."""
    outer = element.parentNode
    while isinstance(outer, Element):
        yield outer
        outer = outer.parentNode


def root_around(element: Element) -> Element:
    """Return the root of the file of an element."""
    return next(reversed(list(around(element))), element)
