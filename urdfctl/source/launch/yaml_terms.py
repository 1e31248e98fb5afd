"""The content of a YAML file as terms, for launch files in Python that load it."""

from __future__ import annotations

from urdfctl.source.launch.terms import MOST_ITEMS, Constant, Items, Plain, Table, Term, UnknownTerm
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, YamlFile

_DEEPEST = 12
_PLAIN: dict[str, Plain] = {
    **dict.fromkeys(("true", "True", "TRUE", "yes", "Yes", "on", "On"), True),
    **dict.fromkeys(("false", "False", "FALSE", "no", "No", "off", "Off"), False),
    **dict.fromkeys(("", "~", "null", "Null", "NULL"), None),
}


def term_of_yaml(file: YamlFile) -> Term | None:
    """Return what `yaml.safe_load` gives for a file; None if it is not one document."""
    return _term(file.documents[0], 0) if file.readable and len(file.documents) == 1 else None


def _term(node: Node, depth: int) -> Term:
    if depth > _DEEPEST:
        return UnknownTerm(node.at)
    if isinstance(node, Scalar):
        return Constant(_value(node), node.at) if node.tag is None else UnknownTerm(node.at)
    if isinstance(node, Mapping):
        table = Table(node.at)
        for entry in node.entries[:MOST_ITEMS]:
            table.put(Constant(entry.key.text, entry.key.at), _term(entry.value, depth + 1))
        return table
    return Items([_term(item, depth + 1) for item in node.items[:MOST_ITEMS]], node.at)


def _value(scalar: Scalar) -> Plain:
    if scalar.style:
        return scalar.text
    if scalar.text in _PLAIN:
        return _PLAIN[scalar.text]
    for kind in (int, float):
        try:
            return kind(scalar.text)
        except ValueError:
            continue
    return scalar.text
