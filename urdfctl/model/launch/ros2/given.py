"""The parameters that a ROS 2 launch file writes as a dict, as the YAML that launch makes of it for the node.

launch_ros writes a dict into a file for the node, or for all nodes of the process (`/**`) if the node has no name
(launch_ros, actions/node.py).
"""

from __future__ import annotations

from urdfctl.model.launch.ros2.texts import Texts
from urdfctl.source.launch.terms import Called, Constant, Items, Table, Term
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, YamlEntry

_DEEPEST = 20


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
    if isinstance(term, Items) and depth < _DEEPEST:
        items = tuple(_node(value, texts, depth + 1) for value in term.values)
        return Sequence(items, None, at.source, at.start, _end(at))
    if isinstance(term, Constant) and not isinstance(term.value, str):
        return _scalar("null" if term.value is None else str(term.value).lower(), "", at)
    text = texts.of(term) if isinstance(term, (Constant, Called)) else UNKNOWN
    return _scalar(text, "" if UNKNOWN in text else '"', at)


def _scalar(text: str, style: str, at: Place) -> Scalar:
    return Scalar(text=text, style=style, tag=None, source=at.source, start=at.start, end=_end(at))


def _end(at: Place) -> int:
    return at.span.end
