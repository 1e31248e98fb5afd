"""Build typed parameters from located YAML, as ROS 1 and ROS 2 read it, and record what their readers reject."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator

from urdfctl.model.controllers.controllers import FaultKind, FileFault, Key, Section
from urdfctl.model.controllers.parameters import Parameter, Parameters, Value, ValueKind
from urdfctl.source.span import Place
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, YamlEntry, YamlFile
from urdfctl.source.yaml.types import TypedScalar, is_literal, typed_by_pyyaml, typed_by_rcl
from urdfctl.startup.records import NamedTuple

PARAMETERS_KEY = "ros__parameters"
_INT32 = range(-(1 << 31), 1 << 31)
_TEXT_KEYS = (ValueKind.STRING, ValueKind.UNKNOWN)


class Leaf(NamedTuple):
    """A parameter or a map of parameters in a ROS 1 file.

    path: the keys that lead to it, including its own.
    key: the place of its own key.
    value: the value.
    """

    path: tuple[str, ...]
    key: Place
    value: Value


class Flat(NamedTuple):
    """The flattened content of a file: sections (ROS 2) or leaves (ROS 1), and faults."""

    sections: list[Section]
    leaves: list[Leaf]
    faults: list[FileFault]


def value_of(node: Node, typed: Callable[[Scalar], TypedScalar]) -> Value:
    """Return the value of a YAML node; `typed` types a scalar as the reader does."""
    if isinstance(node, Scalar):
        kind, value = typed(node)
        return Value(kind, value, node.text, node.at)
    if isinstance(node, Sequence):
        return Value(ValueKind.LIST, None, "", node.at, tuple(_element(item, typed) for item in node.items))
    return Value(ValueKind.MAP, None, "", node.at)


def _element(node: Node, typed: Callable[[Scalar], TypedScalar]) -> Value:
    value = value_of(node, typed)
    if not isinstance(node, Mapping):
        return value
    fields = (Parameter(entry.key.text, entry.key.at, value_of(entry.value, typed)) for entry in node.entries)
    return value._replace(fields=tuple(fields))


def parameters_of(leaves: Iterable[Leaf], base: int = 0) -> Parameters:
    """Return the parameters for some leaves, including the maps that dotted keys imply.

    base: number of leading keys that are left out of the names.
    """
    by_name: dict[str, Parameter] = {}
    for leaf in leaves:
        path = leaf.path[base:]
        for length in range(1, len(path)):
            name = ".".join(path[:length])
            if name not in by_name:
                by_name[name] = Parameter(name, leaf.key, Value(ValueKind.MAP, None, "", leaf.key))
        name = ".".join(path)
        if name in by_name and leaf.value.kind is ValueKind.MAP and by_name[name].value.kind is ValueKind.MAP:
            continue
        by_name[name] = Parameter(name, leaf.key, leaf.value)
    return Parameters(by_name.values())


def with_names_of_elements(leaves: list[Leaf], base: int) -> list[Leaf]:
    """Return the leaves of a section of ROS 1, where the parts of a path that name an element with slashes are one.

    With `joints: [left/elbow]`, `gains: {left/elbow: {p: 1}}` and `gains: {left: {elbow: {p: 1}}}` both set
    `gains.left/elbow.p`: the slash in the name of a joint is that between namespaces.

    base: number of leading keys that are the section's own.
    """
    texts = {item.text for leaf in leaves for item in (leaf.value, *leaf.value.items) if "/" in item.text}
    names = {tuple(text.split("/")) for text in texts} & (_runs_in(leaves, base) if texts else set())
    if not names:
        return leaves
    merged = (leaf._replace(path=(*leaf.path[:base], *_joined(leaf.path[base:], names))) for leaf in leaves)
    holders = {name[:size] for name in names for size in range(1, len(name))}
    return [
        leaf for leaf in merged if leaf.value.kind is not ValueKind.MAP or not _ends_with(leaf.path[base:], holders)
    ]


def _runs_in(leaves: Iterable[Leaf], base: int) -> set[tuple[str, ...]]:
    """All runs of at least two parts in the paths of leaves."""
    paths = {leaf.path[base:] for leaf in leaves}
    return {path[i:j] for path in paths for i in range(len(path)) for j in range(i + 2, len(path) + 1)}


def _joined(path: tuple[str, ...], names: Collection[tuple[str, ...]]) -> Iterator[str]:
    """Yield the parts of a path, those of a name as one."""
    start = 0
    while start < len(path):
        size = max((len(name) for name in names if path[start : start + len(name)] == name), default=1)
        yield "/".join(path[start : start + size])
        start += size


def _ends_with(path: tuple[str, ...], holders: Collection[tuple[str, ...]]) -> bool:
    return any(path[-len(holder) :] == holder for holder in holders)


def tag_faults(file: YamlFile) -> list[FileFault]:
    """Return the tags in a file that make Python objects."""
    return [FileFault(FaultKind.PYTHON_TAG, at) for at in file.python_tags]


# -- ROS 2 -----------------------------------------------------------------------------------------------------------


def read_by_rcl(file: YamlFile) -> Flat:
    """Return the sections of a parameter file, as parse.c of rcl_yaml_param_parser reads them: all documents as one."""
    flat = Flat([], [], [*(FileFault(FaultKind.ALIAS, at) for at in file.aliases), *tag_faults(file)])
    for document in file.documents:
        lost = _lost_indentation(document)
        if lost:
            flat.faults.append(lost)
        elif isinstance(document, Mapping):
            _nodes(document, (), flat)
        elif isinstance(document, Sequence):
            flat.faults.append(FileFault(FaultKind.ROOT, document.at))
    return flat


def _lost_indentation(document: Node) -> FileFault | None:
    """The fault of a document in which `ros__parameters` follows a node's name on the same level, if it is one."""
    above: YamlEntry | None = None
    for entry in document.entries if isinstance(document, Mapping) else ():
        is_name = above is not None and isinstance(above.value, Scalar) and not above.value.text
        if entry.key.text == PARAMETERS_KEY and above is not None and is_name:
            return FileFault(FaultKind.LOST_INDENTATION, entry.key.at, above.key.text)
        above = entry
    return None


def _nodes(mapping: Mapping, keys: tuple[Key, ...], flat: Flat) -> None:
    for key, value in mapping.entries:
        if not key.text.startswith(PARAMETERS_KEY):  # rcl compares only this many characters
            if isinstance(value, Mapping):
                _nodes(value, (*keys, Key(key.text, key.at)), flat)
            else:
                flat.faults.append(FileFault(FaultKind.OUTSIDE_PARAMETERS, key.at, key.text, keys))
            continue
        name, at = "/".join(above.text for above in keys), keys[-1].at if keys else key.at
        if not keys or not _is_node(name):
            flat.faults.append(FileFault(FaultKind.NODE_NAME, at, name, keys))
        elif isinstance(value, Mapping):
            faults: list[FileFault] = []
            leaves = list(_leaves_of_rcl(value, (), faults))
            flat.faults.extend(fault._replace(keys=keys) for fault in faults)
            flat.sections.append(Section(name, at, parameters_of(leaves), key.at))
        elif isinstance(value, Scalar) and typed_by_rcl(value).kind is ValueKind.NULL:
            flat.faults.append(FileFault(FaultKind.EMPTY, key.at, key.text, keys))  # rcl rejects the whole file
        else:
            flat.faults.append(FileFault(FaultKind.PARAMETERS_NOT_A_MAP, key.at, name, keys))


def _is_node(path: str) -> bool:
    """Whether rcl's __validate_name accepts a path: parts of letters, digits and underscores, or whole wildcards."""
    if not is_literal(path) or "<" in path:
        return True
    return all(part in ("*", "**") or _is_name(part) for part in path.removeprefix("/").split("/"))


def _is_name(part: str) -> bool:
    return re.fullmatch(r"[A-Za-z_]\w*", part, re.ASCII) is not None


def _leaves_of_rcl(mapping: Mapping, path: tuple[str, ...], faults: list[FileFault]) -> Iterator[Leaf]:
    for key, written in mapping.entries:
        here, node = (*path, *key.text.split(".")), written
        if isinstance(written, Sequence) and written.items and isinstance(written.items[0], Mapping):
            faults.extend(FileFault(FaultKind.MAP_IN_LIST, item.at, key.text) for item in written.items[1:2])
            node = written.items[0]  # rcl reads the first map of a list instead of the list
        value = value_of(node, typed_by_rcl)
        yield Leaf(here, key.at, value)
        faults.extend(_unexpanded(value, key))
        if not isinstance(node, Scalar) and not value.items and not (isinstance(node, Mapping) and node.entries):
            faults.append(FileFault(FaultKind.EMPTY_COLLECTION, key.at, key.text))
        elif isinstance(node, Mapping):
            yield from _leaves_of_rcl(node, here, faults)
        elif isinstance(node, Sequence):
            faults.extend(_faults_of_list(node, value, key.text))
        elif value.kind is ValueKind.NULL:
            faults.append(FileFault(FaultKind.EMPTY, key.at, key.text))


def _unexpanded(value: Value, key: Scalar) -> Iterator[FileFault]:
    for item in (value, *value.items):
        if "${" in item.text or "$(" in item.text:
            yield FileFault(FaultKind.UNEXPANDED, item.at, key.text)


def _faults_of_list(node: Sequence, value: Value, name: str) -> Iterator[FileFault]:
    first = next((item.kind for item in value.items if item.is_known), None)
    for item, typed in zip(node.items, value.items, strict=True):
        if isinstance(item, Sequence):
            yield FileFault(FaultKind.NESTED_LIST, item.at, name)
            return
        if isinstance(item, Mapping):
            yield FileFault(FaultKind.MAP_IN_LIST, item.at, name)
            return
        if typed.kind is ValueKind.NULL:
            yield FileFault(FaultKind.EMPTY, item.at, name)
        elif typed.is_known and typed.kind is not first:
            yield FileFault(FaultKind.MIXED_LIST, item.at, name)
            return


# -- ROS 1 -----------------------------------------------------------------------------------------------------------


def read_by_rosparam(file: YamlFile, prefix: tuple[str, ...] = ()) -> Flat:
    """Return the parameters of a file, as roslaunch's `<rosparam>` uploads them into the namespace `prefix`."""
    flat = Flat([], [], tag_faults(file))
    if len(file.documents) > 1:
        flat.faults.append(FileFault(FaultKind.DOCUMENTS, file.documents[1].at))
    for document in file.documents[:1]:
        if isinstance(document, Mapping):
            flat.leaves.extend(_leaf_of_namespace(document, prefix))
            flat.leaves.extend(_leaves_of_rosparam(document, prefix, flat.faults))
        elif not isinstance(document, Scalar) or typed_by_pyyaml(document).kind is not ValueKind.NULL:
            flat.faults.append(FileFault(FaultKind.ROOT, document.at))
    return flat


def _leaf_of_namespace(document: Mapping, prefix: tuple[str, ...]) -> Iterator[Leaf]:
    """The controller whose parameters a whole file is, if it is loaded into the namespace of that."""
    key = next((entry.key for entry in document.entries if entry.key.text == "type"), None)
    if prefix and key is not None:
        yield Leaf(prefix, key.at, value_of(document, typed_by_pyyaml))


def _leaves_of_rosparam(mapping: Mapping, path: tuple[str, ...], faults: list[FileFault]) -> Iterator[Leaf]:
    for key, node in _merged(mapping):
        if typed_by_pyyaml(key).kind not in _TEXT_KEYS:
            faults.append(FileFault(FaultKind.KEY, key.at, key.text))
        outer = () if key.text.startswith("/") else path  # roslaunch loader.py add_param(): ns_join(param_name, key)
        here = (*outer, *(part for part in key.text.split("/") if part))
        value = value_of(node, typed_by_pyyaml)
        yield Leaf(here, key.at, value)
        faults.extend(_unexpanded(value, key))
        if isinstance(node, Mapping):
            yield from _leaves_of_rosparam(node, here, faults)
        else:
            faults.extend(_faults_of_value(value, key))


def _merged(mapping: Mapping) -> list[YamlEntry]:
    """The entries of a map with `<<` merged; as in PyYAML, own entries take precedence, then the last of duplicates."""
    inherited: list[YamlEntry] = []
    own: list[YamlEntry] = []
    for entry in mapping.entries:
        if entry.key.text != "<<" or entry.key.style:
            own.append(entry)
            continue
        sources = entry.value.items if isinstance(entry.value, Sequence) else (entry.value,)
        for source in reversed(sources):
            if isinstance(source, Mapping):
                inherited += _merged(source)
    return list({entry.key.text: entry for entry in inherited + own}.values())


def _faults_of_value(value: Value, key: Scalar) -> Iterator[FileFault]:
    for item in (value, *value.items):
        if item.kind is ValueKind.NULL:
            yield FileFault(FaultKind.EMPTY, key.at if item is value else item.at, key.text)
        elif item.kind is ValueKind.OTHER:
            yield FileFault(FaultKind.UNUSABLE, item.at, key.text)
        elif item.kind is ValueKind.INT and item.value not in _INT32:
            yield FileFault(FaultKind.OVERFLOW, item.at, key.text)
