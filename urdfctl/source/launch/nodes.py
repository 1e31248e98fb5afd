"""The places of the nodes of a syntax tree of Python."""

from __future__ import annotations

import ast

from urdfctl.source.span import BOM, Place, SourceText


def place_of(source: SourceText, node: ast.expr | ast.stmt) -> Place:
    """Return the place of a node of a file, from its first to its last byte."""
    starts = source.line_starts()
    bom = len(BOM) if source.data.startswith(BOM) else 0

    def offset(line: int, column: int) -> int:
        return starts[min(line, len(starts)) - 1] + column + (bom if line == 1 else 0)

    end = offset(node.end_lineno or node.lineno, node.end_col_offset or node.col_offset)
    return Place(source, offset(node.lineno, node.col_offset), end=end)


def inside_quotes(at: Place, text: str) -> Place:
    """Return the place of a literal's text without its quotes; the whole literal if the text is written differently."""
    span = at.span
    literal = span.source.data[span.start : span.end]
    if len(literal) > 1 and literal[:1] in {b"'", b'"'} and literal[1:-1] == text.encode("utf-8", "replace"):
        return Place(span.source, span.start + 1, end=span.end - 1)
    return at
