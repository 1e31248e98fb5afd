"""Makes typed parameters of located YAML, as ROS 1 and ROS 2 read them, and notes what their readers refuse."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator

from urdfctl.model.controllers import Fault, FaultKind, Key, Section
from urdfctl.model.parameters import Kind, Parameter, Parameters, Value
from urdfctl.record import NamedTuple
from urdfctl.source.span import Place
from urdfctl.source.yaml import Entry, Mapping, Node, Scalar, Sequence, YamlFile
from urdfctl.source.yaml_types import Typed, is_literal, typed_by_pyyaml, typed_by_rcl

PARAMETERS_KEY = "ros__parameters"
_INT32 = range(-(1 << 31), 1 << 31)
_TEXT_KEYS = (Kind.STRING, Kind.UNKNOWN)


class Leaf(NamedTuple):
    """A parameter or a map with the keys that lead to it."""

    path: tuple[str, ...]
    key: Place
    value: Value


class Flat(NamedTuple):
    """What a file holds, without its nesting: ROS 2's sections, or ROS 1's leaves; and its faults."""

    sections: list[Section]
    leaves: list[Leaf]
    faults: list[Fault]


def value_of(node: Node, typed: Callable[[Scalar], Typed]) -> Value:
    """The value that a node is to its reader."""
    if isinstance(node, Scalar):
        kind, value = typed(node)
        return Value(kind, value, node.text, node.at)
    if isinstance(node, Sequence):
        return Value(Kind.LIST, None, "", node.at, tuple(_element(item, typed) for item in node.items))
    return Value(Kind.MAP, None, "", node.at)


def _element(node: Node, typed: Callable[[Scalar], Typed]) -> Value:
    value = value_of(node, typed)
    if not isinstance(node, Mapping):
        return value
    fields = (Parameter(entry.key.text, entry.key.at, value_of(entry.value, typed)) for entry in node.entries)
    return value._replace(fields=tuple(fields))


def parameters_of(leaves: Iterable[Leaf], base: int = 0) -> Parameters:
    """Parameters of the leaves, named without the first `base` keys, with the maps that dotted keys stand for."""
    found: dict[str, Parameter] = {}
    for leaf in leaves:
        path = leaf.path[base:]
        for length in range(1, len(path)):
            name = ".".join(path[:length])
            if name not in found:
                found[name] = Parameter(name, leaf.key, Value(Kind.MAP, None, "", leaf.key))
        name = ".".join(path)
        if name in found and leaf.value.kind is Kind.MAP and found[name].value.kind is Kind.MAP:
            continue
        found[name] = Parameter(name, leaf.key, leaf.value)
    return Parameters(found.values())


# -- ROS 2 -----------------------------------------------------------------------------------------------------------


def read_by_rcl(file: YamlFile) -> Flat:
    """The sections of a parameter file, as rcl_yaml_param_parser's parse.c collects them; all documents are one."""
    flat = Flat([], [], [Fault(FaultKind.ALIAS, at) for at in file.aliases])
    for document in file.documents:
        if isinstance(document, Mapping):
            _nodes(document, (), flat)
        elif isinstance(document, Sequence):
            flat.faults.append(Fault(FaultKind.ROOT, document.at))
    return flat


def _nodes(mapping: Mapping, keys: tuple[Key, ...], flat: Flat) -> None:
    for key, value in mapping.entries:
        if not key.text.startswith(PARAMETERS_KEY):  # rcl compares no more than these letters
            if isinstance(value, Mapping):
                _nodes(value, (*keys, Key(key.text, key.at)), flat)
            else:
                flat.faults.append(Fault(FaultKind.OUTSIDE_PARAMETERS, key.at, key.text, keys))
            continue
        name, at = "/".join(above.text for above in keys), keys[-1].at if keys else key.at
        if not keys or not _is_node(name):
            flat.faults.append(Fault(FaultKind.NODE_NAME, at, name, keys))
        elif isinstance(value, Mapping):
            found: list[Fault] = []
            leaves = list(_leaves_of_rcl(value, (), found))
            flat.faults.extend(fault._replace(keys=keys) for fault in found)
            flat.sections.append(Section(name, at, parameters_of(leaves), key.at))
        else:
            flat.faults.append(Fault(FaultKind.PARAMETERS_NOT_A_MAP, key.at, name, keys))


def _is_node(path: str) -> bool:
    """Whether rcl's __validate_name takes a path: parts of letters, digits and underscores, or whole wildcards."""
    if not is_literal(path) or "<" in path:
        return True
    return all(part in ("*", "**") or _is_name(part) for part in path.removeprefix("/").split("/"))


def _is_name(part: str) -> bool:
    return re.fullmatch(r"[A-Za-z_]\w*", part, re.ASCII) is not None


def _leaves_of_rcl(mapping: Mapping, path: tuple[str, ...], faults: list[Fault]) -> Iterator[Leaf]:
    for key, written in mapping.entries:
        here, node = (*path, *key.text.split(".")), written
        if isinstance(written, Sequence) and written.items and isinstance(written.items[0], Mapping):
            faults.extend(Fault(FaultKind.MAP_IN_LIST, item.at, key.text) for item in written.items[1:2])
            node = written.items[0]  # rcl takes the first map of a list for the map itself
        value = value_of(node, typed_by_rcl)
        yield Leaf(here, key.at, value)
        if not isinstance(node, Scalar) and not value.items and not (isinstance(node, Mapping) and node.entries):
            faults.append(Fault(FaultKind.EMPTY_COLLECTION, key.at, key.text))
        elif isinstance(node, Mapping):
            yield from _leaves_of_rcl(node, here, faults)
        elif isinstance(node, Sequence):
            faults.extend(_faults_of_list(node, value, key.text))
        elif value.kind is Kind.NULL:
            faults.append(Fault(FaultKind.EMPTY, key.at, key.text))


def _faults_of_list(node: Sequence, value: Value, name: str) -> Iterator[Fault]:
    first = next((item.kind for item in value.items if item.is_known), None)
    for item, typed in zip(node.items, value.items, strict=True):
        if isinstance(item, Sequence):
            yield Fault(FaultKind.NESTED_LIST, item.at, name)
            return
        if isinstance(item, Mapping):
            yield Fault(FaultKind.MAP_IN_LIST, item.at, name)
            return
        if typed.kind is Kind.NULL:
            yield Fault(FaultKind.EMPTY, item.at, name)
        elif typed.is_known and typed.kind is not first:
            yield Fault(FaultKind.MIXED_LIST, item.at, name)
            return


# -- ROS 1 -----------------------------------------------------------------------------------------------------------


def read_by_rosparam(file: YamlFile, prefix: tuple[str, ...] = ()) -> Flat:
    """The parameters of a file, as roslaunch's `<rosparam>` uploads them below a namespace."""
    flat = Flat([], [], [])
    if len(file.documents) > 1:
        flat.faults.append(Fault(FaultKind.DOCUMENTS, file.documents[1].at))
    for document in file.documents[:1]:
        if isinstance(document, Mapping):
            flat.leaves.extend(_leaves_of_rosparam(document, prefix, flat.faults))
        elif not isinstance(document, Scalar) or typed_by_pyyaml(document).kind is not Kind.NULL:
            flat.faults.append(Fault(FaultKind.ROOT, document.at))
    return flat


def _leaves_of_rosparam(mapping: Mapping, path: tuple[str, ...], faults: list[Fault]) -> Iterator[Leaf]:
    for key, node in _merged(mapping):
        if typed_by_pyyaml(key).kind not in _TEXT_KEYS:
            faults.append(Fault(FaultKind.KEY, key.at, key.text))
        here = (*path, *(part for part in key.text.split("/") if part))
        value = value_of(node, typed_by_pyyaml)
        yield Leaf(here, key.at, value)
        if isinstance(node, Mapping):
            yield from _leaves_of_rosparam(node, here, faults)
        else:
            faults.extend(_faults_of_value(value, key))


def _merged(mapping: Mapping) -> list[Entry]:
    """The entries with those that `<<` brings: PyYAML lets the map's own win, and of a key given twice the last."""
    brought: list[Entry] = []
    own: list[Entry] = []
    for entry in mapping.entries:
        if entry.key.text != "<<" or entry.key.style:
            own.append(entry)
            continue
        sources = entry.value.items if isinstance(entry.value, Sequence) else (entry.value,)
        for source in reversed(sources):
            if isinstance(source, Mapping):
                brought += _merged(source)
    return list({entry.key.text: entry for entry in brought + own}.values())


def _faults_of_value(value: Value, key: Scalar) -> Iterator[Fault]:
    for item in (value, *value.items):
        if item.kind is Kind.NULL:
            yield Fault(FaultKind.EMPTY, key.at if item is value else item.at, key.text)
        elif item.kind is Kind.OTHER:
            yield Fault(FaultKind.UNUSABLE, item.at, key.text)
        elif item.kind is Kind.INT and item.value not in _INT32:
            yield Fault(FaultKind.OVERFLOW, item.at, key.text)
