"""The parameters that a ROS 2 launch file writes as a dict, as the YAML that launch makes of it for the node.

launch_ros writes a dict into a file for the node, or for all nodes of the process (`/**`) if the node has no name
(launch_ros, actions/node.py).
"""

from __future__ import annotations

import re

from urdfctl.model.launch.ros2.texts import Texts
from urdfctl.source.launch.terms import Called, Constant, ImportedName, Items, Table, Term
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, YamlEntry

_DEEPEST = 20
_QUOTED = re.compile(r"""(["'])([^"'\\\n]*)\1""")
_NOT_PLAIN = re.compile(r"[\n{}]|: |:$| #|^[&*!|>%@`-](?![\d.])")
"""What is YAML, but no plain or quoted scalar: its value is not read here."""


def section_of(table: Table, node: str, texts: Texts) -> Mapping:
    """Return the document that gives a node the parameters of a dict.

    node: its full name, or a pattern.
    """
    at = table.at
    parameters = _mapping(table, texts, 0)
    inner = Mapping((YamlEntry(_scalar("ros__parameters", "", at), parameters),), None, at.source, at.start, _end(at))
    return Mapping((YamlEntry(_scalar(node, "", at), inner),), None, at.source, at.start, _end(at))


def _mapping(table: Table, texts: Texts, depth: int) -> Mapping:
    """A dict, whose keys may be the parts of a name with dots between them."""
    nested: dict[str, Table] = {}
    entries: list[YamlEntry] = []
    for name, value in table.entries.items():
        first, _, rest = name.partition(".")
        place = table.keys[name]
        if rest:
            inner = nested.get(first)
            if inner is None:
                inner = nested[first] = Table(place)
                entries.append(YamlEntry(_scalar(first, "", place), _scalar("", "", place)))
            inner.entries[rest], inner.keys[rest] = value, place
        else:
            entries.append(YamlEntry(_scalar(name, "", place), _node(value, texts, depth + 1)))
    entries = [
        entry._replace(value=_mapping(nested[entry.key.text], texts, depth)) if entry.key.text in nested else entry
        for entry in entries
    ]
    return Mapping(tuple(entries), None, table.at.source, table.at.start, _end(table.at))


def _node(term: Term, texts: Texts, depth: int) -> Node:
    at = term.at
    if isinstance(term, Table) and depth < _DEEPEST:
        return _mapping(term, texts, depth)
    if isinstance(term, Items) and depth < _DEEPEST and not _is_one_text(term):
        items = tuple(_item(value, texts, depth + 1) for value in term.values)
        return Sequence(items, None, at.source, at.start, _end(at))
    if isinstance(term, Constant) and not isinstance(term.value, str):
        return _scalar("null" if term.value is None else str(term.value).lower(), "", at)
    if isinstance(term, Constant):
        return _string(texts.of(term), at)
    if isinstance(term, Called) and term.short == "ParameterValue":
        return _typed(term, texts, depth)
    return _parsed(texts.of(term), at)


def _is_one_text(term: Items) -> bool:
    """Whether launch_ros joins the parts of a list: substitutions, and texts beside them (normalize_parameters.py)."""
    return any(isinstance(value, Called) for value in term.values) and all(
        isinstance(value, Called) or (isinstance(value, Constant) and isinstance(value.value, str))
        for value in term.values
    )


def _item(term: Term, texts: Texts, depth: int) -> Node:
    """An item of a list; one that is itself a list is the parts of a text."""
    return _parsed(texts.of(term), term.at) if isinstance(term, Items) else _node(term, texts, depth)


def _typed(term: Called, texts: Texts, depth: int) -> Node:
    """A `ParameterValue`: of its type, otherwise as the value in it is."""
    value, kind = term.given("value", 0), term.given("value_type", 1)
    if value is None or depth >= _DEEPEST:
        return _scalar(UNKNOWN, "", term.at)
    if kind is None:
        return _node(value, texts, depth + 1)
    name = kind.path.rpartition(".")[2] if isinstance(kind, ImportedName) else texts.of(kind)
    text = texts.of(value)
    if name == "str":
        return _string(text, value.at)
    return _scalar(text if name in {"bool", "int"} else UNKNOWN, "", value.at)


def _parsed(text: str, at: Place) -> Node:
    """What launch_ros reads in the text of a substitution: YAML (evaluate_parameters.py)."""
    if not text:
        return _scalar("", '"', at)
    if text.strip().startswith("[") or _NOT_PLAIN.search(text):
        return _scalar(UNKNOWN, "", at)
    quoted = _QUOTED.fullmatch(text.strip())
    return _scalar(quoted[2], quoted[1], at) if quoted else _scalar(text.strip(), "", at)


def _string(text: str, at: Place) -> Scalar:
    return _scalar(text, "" if UNKNOWN in text else '"', at)


def _scalar(text: str, style: str, at: Place) -> Scalar:
    return Scalar(text=text, style=style, tag=None, source=at.source, start=at.start, end=_end(at))


def _end(at: Place) -> int:
    return at.span.end
