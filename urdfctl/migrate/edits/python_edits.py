"""Places of calls, lists and dicts in Python files, and edits of them that keep everything else."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from urdfctl.diagnostic import Edit
from urdfctl.source.span import Place, SourceSpan, SourceText

_MOST_COLUMNS = 99
"""The longest line that is written, as in ROS 2's own Python code."""


class PythonFile:
    """A Python file with its syntax tree.

    tree: None if it is not valid Python.
    """

    def __init__(self, source: SourceText) -> None:
        self.source = source
        self.tree = _parsed(source.data)

    def calls(self, *names: str) -> Iterator[tuple[ast.Call, ast.AST]]:
        """Yield the calls of functions with these names, each with the innermost function around it, or the module."""
        pending: list[tuple[ast.AST, ast.AST]] = [(self.tree, self.tree)] if self.tree else []
        while pending:
            node, scope = pending.pop(0)
            if isinstance(node, ast.Call) and called(node) in names:
                yield node, scope
            inner = node if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)) else scope
            pending += [(child, inner) for child in ast.iter_child_nodes(node)]

    def span(self, node: ast.expr | ast.keyword | ast.stmt) -> SourceSpan:
        """Return the span of a node."""
        start = self._offset(node.lineno, node.col_offset)
        return SourceSpan(self.source, start, self._offset(node.end_lineno or 0, node.end_col_offset or 0))

    def at(self, node: ast.expr | ast.keyword | ast.stmt) -> Place:
        """Return the place of a node."""
        span = self.span(node)
        return Place(self.source, span.start, end=span.end)

    def text(self, node: ast.expr) -> str:
        """Return the text of a node."""
        return self.span(node).text

    def indent_of(self, node: ast.expr | ast.stmt) -> str:
        """Return the blanks and tabs at the start of the line on which a node begins."""
        start = self.span(node).start
        line = self.source.data[self.source.data.rfind(b"\n", 0, start) + 1 : start].decode("utf-8", "replace")
        return line[: len(line) - len(line.lstrip())]

    def value_of(self, node: ast.expr, scope: ast.AST) -> ast.expr:
        """Return the expression that a name was last assigned in a scope or the module; any other node itself."""
        if not isinstance(node, ast.Name):
            return node
        for around in (scope, self.tree):
            found = [
                statement.value
                for statement in ast.walk(around or node)
                if isinstance(statement, ast.Assign)
                for target in statement.targets
                if isinstance(target, ast.Name) and target.id == node.id
            ]
            if found:
                return found[-1]
        return node

    def without(self, items: list[ast.expr] | list[ast.keyword], gone: ast.expr | ast.keyword) -> Edit:
        """Return the edit that removes an item of a list or a keyword of a call, with its comma and its line."""
        spans = [self.span(item) for item in items]
        index = next(number for number, item in enumerate(items) if item is gone)
        data = self.source.data
        start, end = spans[index].start, spans[index].end
        comma = _after_blanks(data, end)
        if data[comma : comma + 1] == b",":
            end = comma + 1
        elif index:
            start = spans[index - 1].end
        line_start = data.rfind(b"\n", 0, start) + 1
        line_end = data.find(b"\n", end)
        if not data[line_start:start].strip() and line_end >= 0 and not data[end:line_end].strip():
            start, end = line_start, line_end + 1
        elif data[end : end + 1] == b" " and index + 1 < len(items):
            end += 1
        return Edit(SourceSpan(self.source, start, end), "")

    def without_all(self, items: list[ast.expr], gone: list[ast.expr]) -> Iterator[Edit]:
        """Yield the edits that remove some items of a list."""
        spans = [self.span(item) for item in items]
        last = -1
        for index, item in enumerate(items):
            if item not in gone:
                if last >= 0 and index - last > 1:
                    yield Edit(SourceSpan(self.source, spans[last].end, spans[index - 1].end), "")
                elif last < 0 < index:
                    yield Edit(SourceSpan(self.source, spans[0].start, spans[index].start), "")
                last = index
        if last < len(items) - 1 and items:
            start = spans[last].end if last >= 0 else spans[0].start
            yield Edit(SourceSpan(self.source, start, spans[-1].end), "")

    def appended(self, items: ast.List, texts: list[str], others: Iterable[Edit] = ()) -> Edit:
        """Return the edit that adds items at the end of a list, on lines of their own if its items are, or must be.

        others: edits that are made too; a list with one of them inside stays on its line, however long that is.
        """
        data = self.source.data
        closing = self.span(items).end - 1
        if not items.elts:
            return Edit(SourceSpan(self.source, closing, closing), ", ".join(texts))
        last = self.span(items.elts[-1]).end
        comma = _after_blanks(data, last)
        has_comma = data[comma : comma + 1] == b","
        at = comma + 1 if has_comma else last
        line_start = data.rfind(b"\n", 0, self.span(items.elts[-1]).start) + 1
        indent = data[line_start : self.span(items.elts[-1]).start]
        if b"\n" not in data[at:closing] or indent.strip():
            inline = f"{' ' if has_comma else ', '}{', '.join(texts)}"
            span = self.span(items)
            is_edited = any(span.start <= one.span.start and one.span.end <= span.end for one in others)
            if is_edited or self._fits(items, inline):
                return Edit(SourceSpan(self.source, at, at), inline)
            return Edit(span, self._on_lines([*map(self.text, items.elts), *texts], line_start))
        margin = f"\n{indent.decode()}"
        text = margin + f",{margin}".join(texts) + "," * has_comma
        return Edit(SourceSpan(self.source, at, at), text if has_comma else f",{text}")

    def _fits(self, items: ast.List, inline: str) -> bool:
        """Whether a line is not too long with a text; a list on several lines is left as it is."""
        start, end = self.span(items).start, self.span(items).end
        line_start, line_end = self.source.data.rfind(b"\n", 0, start) + 1, self.source.data.find(b"\n", end)
        is_on_one_line = b"\n" not in self.source.data[start:end]
        return not is_on_one_line or line_end - line_start + len(inline) <= _MOST_COLUMNS

    def _on_lines(self, texts: list[str], line_start: int) -> str:
        """A list with each item on a line of its own, indented from the line that it begins on."""
        line = self.source.data[line_start : self.source.data.find(b"\n", line_start)].decode("utf-8", "replace")
        indent = line[: len(line) - len(line.lstrip())]
        return "[" + "".join(f"\n{indent}    {text}," for text in texts) + f"\n{indent}]"

    def imports(self, module: str, name: str) -> Edit | None:
        """Return the edit that imports a name from a module; None if the file has the name."""
        tree = self.tree
        if tree is None:
            return None
        froms = [node for node in tree.body if isinstance(node, ast.ImportFrom)]
        if any(alias.name == name for node in froms for alias in node.names):
            return None
        imports = [node for node in tree.body if isinstance(node, (ast.Import, ast.ImportFrom))]
        start = self.source.data.find(b"\n", self.span(imports[-1]).end) + 1 if imports else 0
        return Edit(SourceSpan(self.source, start, start), f"from {module} import {name}\n")

    def all_imports(self, names: Iterable[tuple[str, str]]) -> list[Edit]:
        """Return the one edit that imports some names, each a module and a name in it, if the file lacks any."""
        found = [self.imports(module, name) for module, name in dict.fromkeys(names)]
        edits = [edit for edit in found if edit is not None]
        return [Edit(edits[0].span, "".join(edit.text for edit in edits))] if edits else []

    def _offset(self, line: int, column: int) -> int:
        return self.source.line_starts()[line - 1] + column


def _parsed(data: bytes) -> ast.Module | None:
    try:
        return ast.parse(data)
    except (SyntaxError, ValueError, RecursionError):
        return None


def is_python(data: bytes) -> bool:
    """Return whether a file is valid Python."""
    return _parsed(data) is not None


def called(node: ast.Call) -> str:
    """Return the last part of the name of a called function; empty if it has none."""
    if isinstance(node.func, ast.Attribute):
        return node.func.attr
    return node.func.id if isinstance(node.func, ast.Name) else ""


def keyword(node: ast.Call, name: str) -> ast.keyword | None:
    """Return a keyword argument of a call, if it has it."""
    return next((one for one in node.keywords if one.arg == name), None)


def text_of(node: ast.expr | None) -> str:
    """Return the value of a string; empty if it is anything else."""
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""


def outermost(edits: Iterable[Edit]) -> Iterator[Edit]:
    """Yield each edit once, without those that are inside the span of another one."""
    distinct = list(dict.fromkeys(edits))
    spans = [edit.span for edit in distinct]
    for edit in distinct:
        inside = (span for span in spans if span is not edit.span and span.start < span.end)
        if not any(span.start <= edit.span.start and edit.span.end <= span.end for span in inside):
            yield edit


def _after_blanks(data: bytes, offset: int) -> int:
    while data[offset : offset + 1] in (b" ", b"\t", b"\n", b"\r"):
        offset += 1
    return offset
