"""The elements of XML files as they are written: their bytes, their lines, their texts, and what they are in."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfctl.diagnostic import Edit
from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.xml.dom import COMMENT, Element, XmlText
from urdfctl.source.xml.parsing import parse
from urdfctl.startup.per_object import once_per_object

CONDITIONS = frozenset({"xacro:if", "xacro:unless"})
MACRO = "xacro:macro"


@once_per_object
def root_of(source: SourceText) -> Element | None:
    """Return the root element of a file as it is written; None if the file is not XML."""
    try:
        return parse(source).documentElement
    except ReadError:
        return None


def elements(root: Element) -> Iterator[Element]:
    """Yield an element and all elements in it, in the order of the file."""
    yield from root.walk()


@once_per_object
def _by_start(source: SourceText) -> dict[int, Element]:
    root = root_of(source)
    return {element.start: element for element in elements(root)} if root is not None else {}


def element_at(source: SourceText, start: int) -> Element | None:
    """Return the element whose start tag is at a byte offset."""
    return _by_start(source).get(start)


def parent_of(element: Element) -> Element | None:
    """Return the element that contains another; None for the root."""
    return element.parentNode if isinstance(element.parentNode, Element) else None


def ancestors(element: Element) -> Iterator[Element]:
    """Yield the elements around another, innermost first."""
    above = parent_of(element)
    while above is not None:
        yield above
        above = parent_of(above)


def end_of(element: Element) -> int:
    """Return the offset after the last byte of an element."""
    tag = element.source.start_tag(element.start)
    if tag is not None and (tag.self_closed or element.close is None):
        return tag.end
    return element.source.data.index(b">", element.close) + 1 if element.close is not None else element.start


def span_of(element: Element) -> SourceSpan:
    """Return the bytes of an element."""
    return SourceSpan(element.source, element.start, end_of(element))


def lines_of(element: Element, *, with_comment: bool = False) -> SourceSpan:
    """Return the whole lines of an element if nothing else is on them, otherwise its bytes.

    with_comment: with the comment on the lines directly above, which is about the element.
    """
    source, span = element.source, span_of(element)
    data = source.data
    start = data.rfind(b"\n", 0, span.start) + 1
    stop = data.find(b"\n", span.end)
    stop = len(data) if stop < 0 else stop + 1
    if data[start : span.start].strip() or data[span.end : stop].strip():
        return span
    above = _comment_above(element) if with_comment else None
    return SourceSpan(source, start if above is None else above, stop)


def _comment_above(element: Element) -> int | None:
    """The offset of the line where the comment directly above an element begins."""
    data = element.source.data
    line = data.rfind(b"\n", 0, element.start) + 1
    if not data[:line].rstrip(b" \t\r\n").endswith(b"-->") or re.search(rb"\n[ \t]*\r?\n\Z", data[:line]):
        return None
    opened = data.rfind(b"<!--", 0, line)
    start = data.rfind(b"\n", 0, opened) + 1
    return start if not data[start:opened].strip() else None


def removal(element: Element) -> Edit:
    """Return the edit that removes an element with its comment, and one of the blank lines around it."""
    span = lines_of(element, with_comment=True)
    data = span.source.data
    blank = re.compile(rb"[ \t]*\r?\n").match(data, span.end)
    if blank and data[: span.start].rstrip(b" \t").endswith((b"\n\n", b"\n\r\n")):
        span = span._replace(end=blank.end())
    return Edit(span, "")


def appended(element: Element, lines: Iterable[str]) -> Edit:
    """Return the edit that adds lines, with their blanks, at the end of an element's content."""
    close = element.close or end_of(element)
    end = element.source.data.rfind(b"\n", 0, close) + 1
    if element.source.data[end:close].strip():
        return Edit(SourceSpan(element.source, close, close), "".join(line.strip() for line in lines))
    return Edit(SourceSpan(element.source, end, end), "".join(f"{line}\n" for line in lines))


def merged(edits: Iterable[Edit]) -> Edit:
    """Return one edit that makes all of some edits of a file, which may touch but not overlap."""
    ordered = sorted(edits, key=lambda edit: (edit.span.start, edit.span.end))
    source, position = ordered[0].span.source, ordered[0].span.start
    pieces = []
    for edit in ordered:
        pieces += [SourceSpan(source, position, edit.span.start).text, edit.text]
        position = max(position, edit.span.end)
    return Edit(SourceSpan(source, ordered[0].span.start, position), "".join(pieces))


def indent_of(element: Element) -> str:
    """Return the blanks before an element in its line."""
    line = element.source.data.rfind(b"\n", 0, element.start) + 1
    before = element.source.data[line : element.start]
    return before[: len(before) - len(before.lstrip())].decode()


def step_of(source: SourceText) -> str:
    """Return the blanks by which a file indents the children of its root; two spaces if that is not clear."""
    root = root_of(source)
    child = next(iter(root.elements()), None) if root is not None else None
    indent = indent_of(child) if child is not None else ""
    return indent if indent in {"  ", "    ", "\t", "   "} else "  "


def indented(text: str, indent: str) -> str:
    """Return a text with blanks before each of its lines that are not empty."""
    return "".join(f"{indent}{line}" if line.strip() else line for line in text.splitlines(keepends=True))


def dedented(text: str, indent: str) -> str:
    """Return a text without the blanks of a place before each of its lines."""
    return "".join(line.removeprefix(indent) for line in text.splitlines(keepends=True))


def attribute(element: Element, name: str) -> str:
    """Return the value of an attribute as it is written, with its entities; empty if missing."""
    tag = element.source.start_tag(element.start)
    if tag is None or name not in tag.attributes:
        return ""
    start, end = tag.attributes[name]
    return element.source.data[start:end].decode("utf-8", "surrogateescape")


def with_attribute(element: Element, name: str, value: str) -> Edit:
    """Return the edit that gives an element an attribute, or another value for one that it has."""
    tag = element.source.start_tag(element.start)
    if tag is not None and name in tag.attributes:
        return Edit(SourceSpan(element.source, *tag.attributes[name]), value)
    start = element.start + len(f"<{element.tagName}".encode())
    return Edit(SourceSpan(element.source, start, start), f' {name}="{value}"')


def content(element: Element) -> str:
    """Return the text in an element as it is written, without blanks around it and without comments."""
    return written_in(element).strip()


def written_in(element: Element) -> str:
    """Return the text in an element as it is written, without comments."""
    if element.close is None:
        return ""
    tag = element.source.start_tag(element.start)
    inside = element.source.data[tag.end if tag else element.start : element.close].decode("utf-8", "surrogateescape")
    return re.sub(r"(?s)<!--.*?-->", "", inside)


def is_zero(element: Element) -> bool:
    """Return whether an element contains nothing, or the number zero: a setting that says what is so without it."""
    return re.fullmatch(r"[0.\s]*", content(element)) is not None


def child(element: Element, name: str) -> Element | None:
    """Return the first child with a name."""
    return next((one for one in element.elements() if one.tagName == name), None)


def children(element: Element, name: str) -> Iterator[Element]:
    """Yield the children with a name."""
    return (one for one in element.elements() if one.tagName == name)


def is_alone(first: Element, last: Element) -> bool:
    """Return whether only blanks and comments are between two siblings."""
    node = first.nextSibling
    while node is not None and node is not last:
        if not isinstance(node, XmlText) or (node.nodeType != COMMENT and node.data.strip()):
            return False
        node = node.nextSibling
    return node is last
