"""The values and words of a file that may be names: attributes and texts of XML, scalars of YAML, strings of Python."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, read_yaml

XML = (".xacro", ".urdf", ".xml", ".launch", ".srdf", ".sdf", ".world", ".gazebo", ".inc", ".trans")
HOOKS = (".dsv", ".dsv.in", ".sh", ".sh.in", ".bash")
"""Files that set the environment."""
_SKIPPED = rb"(?s)<!--.*?(?:-->|\Z)|<\?.*?\?>"
_TAG = re.compile(rb"<(/?)([A-Za-z_][\w:.-]*)((?:\s+[\w:.-]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*)\s*/?>")
_VALUE = re.compile(rb"=\s*(?:\"([^\"]*)\"|'([^']*)')")


def tokens_in(source: SourceText, element: str = "") -> Iterator[SourceSpan]:
    """Yield the spans of a file's values, without quotes and surrounding blanks. Comments are left out.

    element: only the attributes of this XML element.
    """
    if element:
        return _of_xml(source, element) if source.path.endswith(XML) else iter(())
    if source.path.endswith(".py"):
        return _of_python(source)
    if source.path.endswith((".yaml", ".yml")):
        return _of_yaml(source)
    if source.path.endswith(HOOKS):
        return _of_lines(source)
    return _of_xml(source) if source.path.endswith(XML) else iter(())


def elements_in(source: SourceText) -> Iterator[SourceSpan]:
    """Yield the spans of the names of all elements in an XML file, in start tags and end tags."""
    data = _without_comments(source.data)
    for tag in _TAG.finditer(data):
        yield SourceSpan(source, tag.start(2), tag.end(2))


def _without_comments(data: bytes) -> bytes:
    """The text with blanks in place of comments and instructions, so that offsets stay."""
    return re.sub(_SKIPPED, lambda match: b" " * len(match[0]), data)


def _of_xml(source: SourceText, element: str = "") -> Iterator[SourceSpan]:
    data = _without_comments(source.data)
    position = 0
    for tag in _TAG.finditer(data):
        text = data[position : tag.start()]
        if text.strip() and not element:
            yield SourceSpan(source, position + len(text) - len(text.lstrip()), position + len(text.rstrip()))
        is_wanted = not element or tag[2].decode() == element
        for value in _VALUE.finditer(data, tag.start(3), tag.end(3)) if is_wanted else ():
            group = 1 if value[1] is not None else 2
            yield SourceSpan(source, value.start(group), value.end(group))
        position = tag.end()


def _of_lines(source: SourceText) -> Iterator[SourceSpan]:
    """The lines of a file of the shell's kind that are no comments."""
    for line in re.finditer(rb"(?m)^[ \t]*([^#\s].*?)[ \t]*$", source.data):
        yield SourceSpan(source, line.start(1), line.end(1))


def _of_yaml(source: SourceText) -> Iterator[SourceSpan]:
    pending: list[Node] = list(read_yaml(source).documents)
    while pending:
        node = pending.pop()
        if isinstance(node, Scalar):
            quote = len(node.style) if node.style in ("'", '"') else 0
            yield SourceSpan(source, node.start + quote, node.end - quote)
        elif isinstance(node, Mapping):
            pending += [part for entry in node.entries for part in (entry.key, entry.value)]
        else:
            pending += node.items


def _of_python(source: SourceText) -> Iterator[SourceSpan]:
    """The contents of string literals that are written as they are: without escapes, in one literal."""
    try:
        tree = ast.parse(source.data)
    except (SyntaxError, ValueError, RecursionError):
        return
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.end_col_offset is not None:
            start = _offset(source, node.lineno, node.col_offset)
            end = _offset(source, node.end_lineno or node.lineno, node.end_col_offset)
            content = node.value.encode("utf-8", "surrogateescape")
            found = source.data.find(content, start, end)
            if content and found >= 0:
                yield SourceSpan(source, found, found + len(content))


def _offset(source: SourceText, line: int, column: int) -> int:
    return source.line_starts()[line - 1] + column
