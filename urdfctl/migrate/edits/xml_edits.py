"""Edits of elements in XML files that keep comments, order and formatting."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.source.xml.parsing import parse


def elements_of(source: SourceText) -> Iterator[Element]:
    """Yield the elements of a file as they are written, outer ones first; none if it is not well-formed."""
    try:
        root = parse(source).documentElement
    except ReadError:
        return
    if root is not None:
        yield from root.walk()


def span_of(element: Element) -> SourceSpan:
    """Return the span of an element with its content and end tag."""
    source = element.source
    tag = source.start_tag(element.start)
    if element.close is None or tag is None or tag.self_closed:
        return SourceSpan(source, element.start, tag.end if tag else element.start)
    return SourceSpan(source, element.start, source.data.find(b">", element.close) + 1)


def removed(element: Element) -> Edit:
    """Return the edit that removes an element, with its line if nothing else is in it."""
    source, start, end = span_of(element)
    line_start = source.data.rfind(b"\n", 0, start) + 1
    line_end = source.data.find(b"\n", end)
    if line_end >= 0 and not source.data[line_start:start].strip() and not source.data[end:line_end].strip():
        start, end = line_start, line_end + 1
    return Edit(SourceSpan(source, start, end), "")


def inserted(parent: Element, text: str) -> Edit | None:
    """Return the edit that adds a child at the end of an element, indented as its last child.

    None if the element has no end tag of its own.
    """
    source, children = parent.source, parent.elements()
    if parent.close is None:
        return None
    if not children:
        return Edit(SourceSpan(source, parent.close, parent.close), text)
    last = span_of(children[-1])
    line = source.data.rfind(b"\n", 0, last.start) + 1
    indent = source.data[line : last.start]
    lead = "" if indent.strip() else f"\n{indent.decode('utf-8', 'replace')}"
    return Edit(SourceSpan(source, last.end, last.end), f"{lead}{text}")


def words_of(element: Element) -> str:
    """Return the content of an element as it is written, without surrounding blanks."""
    source, start, end = span_of(element)
    tag = source.start_tag(start)
    content = source.data[tag.end if tag else start : element.close or end]
    return content.decode("utf-8", "replace").strip()
