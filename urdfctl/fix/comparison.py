"""Check that a robot is the same before and after edits, except for the edited parts.

The comparison covers all parts of the expanded tree, and of the edited files, that no edit touches. A part is
identified by its byte offset, which earlier edits in the file may have moved.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Mapping
from itertools import zip_longest
from typing import TYPE_CHECKING

from urdfctl.fix.edits import Shift, Splice
from urdfctl.source.disk.files import is_yaml
from urdfctl.source.problem import ReadError
from urdfctl.source.span import Call, SourceText
from urdfctl.source.xml.dom import COMMENT, Element, XmlText
from urdfctl.source.xml.parsing import parse
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.source.yaml import tree as yaml

Files = Mapping[str, "EditedFile"]
"""The edited files, by the path that places use."""


class EditedFile(NamedTuple):
    """A file with edits: the new offsets of its bytes, and the parts that the edits touch."""

    shift: Shift
    touched: Mapping[int, tuple[Splice, ...]]
    """The edits that touch each part, by the part's offset before the edits."""
    touched_after: frozenset[int]
    """The offsets of the touched parts after the edits."""


def edited_file(source: SourceText, edits: Iterable[Splice]) -> EditedFile:
    """Return how edits change one file."""
    shift = Shift(edits)
    find = _scalars_touched if is_yaml(source.path) else _elements_touched
    touched: dict[int, list[Splice]] = {}
    for start, edit in find(source, shift.edits):
        touched.setdefault(start, []).append(edit)
    after = frozenset(moved for start in touched if (moved := shift.of(start)) is not None)
    return EditedFile(shift, {start: tuple(own) for start, own in touched.items()}, after)


def _elements_touched(source: SourceText, edits: list[Splice]) -> Iterator[tuple[int, Splice]]:
    """Each edit, with the offset of the innermost element that contains it."""
    root = _xml(source)
    spans = [(element.start, _end(element)) for element in root.walk()] if root is not None else []
    starts = [start for start, _ in spans]
    for edit in edits:
        before = spans[: bisect_left(starts, edit.start)]
        around = (start for start, end in reversed(before) if edit.end < end or edit.start < edit.end == end)
        yield from ((start, edit) for start in [next(around, None)] if start is not None)


def _scalars_touched(source: SourceText, edits: list[Splice]) -> Iterator[tuple[int, Splice]]:
    from urdfctl.source.yaml.tree import Scalar

    for node, _ in _nodes(source):
        if isinstance(node, Scalar):
            yield from ((node.start, edit) for edit in edits if edit.start <= node.end and node.start <= edit.end)


def _xml(source: SourceText) -> Element | None:
    try:
        return parse(source).documentElement
    except ReadError:
        return None


def _end(element: Element) -> int:
    tag = element.source.start_tag(element.start)
    if element.close is None or (tag is not None and tag.self_closed):
        return tag.end if tag is not None else element.start
    return element.source.data.find(b">", element.close) + 1


def _nodes(source: SourceText) -> Iterator[tuple[yaml.Node, int]]:
    """The nodes of a YAML file in order, each with the number of its parent node, -1 for none."""
    from urdfctl.source.yaml.tree import Mapping as Map
    from urdfctl.source.yaml.tree import Scalar, read_yaml

    pending: list[tuple[yaml.Node, int]] = [(document, -1) for document in reversed(read_yaml(source).documents)]
    number = -1
    while pending:
        node, around = pending.pop()
        yield node, around
        number += 1
        if isinstance(node, Map):
            pending += [(part, number) for entry in reversed(node.entries) for part in (entry.value, entry.key)]
        elif not isinstance(node, Scalar):
            pending += [(item, number) for item in reversed(node.items)]


# -- unchanged parts ---------------------------------------------------------------------------------------------------


class _Part(NamedTuple):
    """A part that exists before and after the edits."""

    file: str
    start: int
    """Its offset after the edits."""
    parent: int
    """The number of the part that contains it, -1 for none."""
    content: object
    """None if an edit touches the part, so that its content may differ."""


def same_tree(before: Element | None, after: Element | None, files: Files) -> bool:
    """Return whether two expanded trees differ only in parts that the edits change, add or remove."""
    if before is None:  # where there was no robot, none of its parts can change
        return True
    if after is None:
        return False
    pairs = zip_longest(_tree(before, _Before(files)), _tree(after, _After(files)))
    return all(old == new for old, new in pairs)


def same_file(before: SourceText, after: SourceText, edited: EditedFile) -> bool:
    """Return whether two states of a file differ only in parts that the edits change, add or remove."""
    files = {before.path: edited}
    if is_yaml(before.path):
        pairs = zip_longest(_yaml(before, _Before(files)), _yaml(after, _After(files)))
        return all(old == new for old, new in pairs)
    root, other_root = _xml(before), _xml(after)
    return root is None or same_tree(root, other_root, files)


class _Before:
    """The parts before the edits: their offset after the edits (None if removed), and whether an edit touches them."""

    def __init__(self, files: Files) -> None:
        self.files = files

    def start(self, file: str, offset: int) -> int | None:
        edited = self.files.get(file)
        return edited.shift.of(offset) if edited else offset

    def is_touched(self, file: str, offset: int) -> bool:
        edited = self.files.get(file)
        return edited is not None and offset in edited.touched


class _After:
    """The parts after the edits: their offset (None if an edit added them), and whether an edit touches them."""

    def __init__(self, files: Files) -> None:
        self.files = files

    def start(self, file: str, offset: int) -> int | None:
        edited = self.files.get(file)
        return None if edited and edited.shift.is_new(offset) else offset

    def is_touched(self, file: str, offset: int) -> bool:
        edited = self.files.get(file)
        return edited is not None and offset in edited.touched_after


def _tree(root: Element, state: _Before | _After) -> Iterator[_Part]:
    """The elements that are kept, in order. Elements from a call that is edited are left out."""
    called: dict[int, bool] = {}
    pending = [(root, -1)]
    number = -1
    while pending:
        element, around = pending.pop()
        file, start = element.source.path, state.start(element.source.path, element.start)
        if start is not None and not _is_call_edited(element.call, state, called):
            number += 1
            touched = state.is_touched(file, element.start)
            yield _Part(file, start, around, None if touched else _content(element))
            around = number
        pending += [(child, around) for child in reversed(element.elements())]


def _is_call_edited(call: Call | None, state: _Before | _After, known: dict[int, bool]) -> bool:
    if call is None:
        return False
    if id(call) not in known:
        file = call.source.path
        is_edited = state.start(file, call.offset) is None or state.is_touched(file, call.offset)
        known[id(call)] = is_edited or _is_call_edited(call.parent, state, known)
    return known[id(call)]


def _content(element: Element) -> object:
    texts = (node.data for node in element.children() if isinstance(node, XmlText) and node.nodeType != COMMENT)
    return element.tagName, element.attrs, [text for text in texts if text.strip()]


def _yaml(source: SourceText, state: _Before | _After) -> Iterator[_Part]:
    from urdfctl.source.yaml.tree import Scalar

    numbers: list[int] = []
    number = -1
    for node, around in _nodes(source):
        inside = numbers[around] if around >= 0 else -1
        start = state.start(source.path, node.start)
        if start is None:
            numbers.append(inside)
            continue
        number += 1
        numbers.append(number)
        touched = state.is_touched(source.path, node.start)
        content = (node.text, node.style) if isinstance(node, Scalar) else ()
        yield _Part(source.path, start, inside, None if touched else (type(node).__name__, node.tag, content))
