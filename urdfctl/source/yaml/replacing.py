"""Replace texts in a YAML file, as launch files do before they load it."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, YamlEntry, YamlFile

_DEEPEST = 40
_MOST_CHARACTERS = 1 << 16


def with_replacements(file: YamlFile, pairs: Iterable[tuple[str, str]]) -> YamlFile:
    """Return a file whose keys and scalars have texts replaced; each keeps its place in the file.

    A scalar that becomes a list or map is unknown.
    """
    used = [(old, new) for old, new in pairs if old and old.encode() in file.source.data]
    if not used:
        return file
    return file._replace(documents=tuple(_replaced(document, used, 0) for document in file.documents))


def with_values(file: YamlFile, values: Iterable[tuple[str, str]]) -> YamlFile:
    """Return a file in which the scalars below some keys have other texts; each keeps its place in the file."""
    wanted = dict(values)
    return file._replace(documents=tuple(_with(each, wanted, 0) for each in file.documents)) if wanted else file


def _with(node: Node, values: dict[str, str], depth: int) -> Node:
    if isinstance(node, Sequence) and depth < _DEEPEST:
        return node._replace(items=tuple(_with(item, values, depth + 1) for item in node.items))
    if not isinstance(node, Mapping) or depth >= _DEEPEST:
        return node
    entries = (
        entry._replace(
            value=entry.value._replace(text=values[entry.key.text])
            if isinstance(entry.value, Scalar) and entry.key.text in values
            else _with(entry.value, values, depth + 1)
        )
        for entry in node.entries
    )
    return node._replace(entries=tuple(entries))


def below(file: YamlFile, root: str) -> YamlFile:
    """Return a file with all that it contains below a key; the file itself if the key is empty."""
    if not root:
        return file
    documents = []
    for node in file.documents:
        key = Scalar(text=root, style="", tag=None, source=node.source, start=node.start, end=node.start)
        documents.append(Mapping((YamlEntry(key, node),), None, node.source, node.start, node.end))
    return file._replace(documents=tuple(documents))


def _replaced(node: Node, pairs: list[tuple[str, str]], depth: int) -> Node:
    if depth > _DEEPEST:
        return node
    if isinstance(node, Scalar):
        return _scalar(node, pairs)
    if isinstance(node, Sequence):
        return node._replace(items=tuple(_replaced(item, pairs, depth + 1) for item in node.items))
    entries = (YamlEntry(_scalar(entry.key, pairs), _replaced(entry.value, pairs, depth + 1)) for entry in node.entries)
    return node._replace(entries=tuple(entries)) if isinstance(node, Mapping) else node


def _scalar(scalar: Scalar, pairs: list[tuple[str, str]]) -> Scalar:
    text = scalar.text
    for old, new in pairs:
        text = text.replace(old, new)
    if text == scalar.text:
        return scalar
    if len(text) > _MOST_CHARACTERS or (not scalar.style and text.lstrip()[:1] in {"[", "{"}):
        text = UNKNOWN
    return scalar._replace(text=text)
