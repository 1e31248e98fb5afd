"""Install rules of a setup.py, read from its syntax tree."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator

from urdfctl.source.disk.gate import matching
from urdfctl.source.workspaces.installed import Installed, below_share, installed


def rules_of_setup(text: str, folder: str, package: str) -> Iterator[Installed]:
    """Yield the install rules of the pairs in `data_files` that are literal."""
    if "data_files" not in text:
        return
    for node in _nodes(text):
        if isinstance(node, ast.Tuple) and len(node.elts) == 2:  # noqa: PLR2004 (a pair of data_files)
            destination = _text_of(node.elts[0], package)
            target = below_share(destination, package) if destination else None
            if target is not None:
                for source in _sources_of(node.elts[1], package):
                    yield from _matching(folder, target, source)


def is_plain_setup(text: str, package: str) -> bool:
    """Return whether all data files in a setup.py are given as literal paths or patterns."""
    data_files = [
        keyword.value
        for node in _nodes(text)
        if isinstance(node, ast.Call)
        for keyword in node.keywords
        if keyword.arg == "data_files"
    ]
    if len(data_files) != 1 or not isinstance(data_files[0], ast.List):
        return False
    return all(isinstance(pair, ast.Tuple) and _is_plain_pair(pair.elts, package) for pair in data_files[0].elts)


def _nodes(text: str) -> Iterator[ast.AST]:
    """All nodes of the syntax tree; none if the text is not valid Python."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return
    yield from ast.walk(tree)


def _is_plain_pair(pair: list[ast.expr], package: str) -> bool:
    if len(pair) != 2 or _text_of(pair[0], package) is None:  # noqa: PLR2004 (destination and files)
        return False
    if isinstance(pair[1], ast.List):
        return all(_text_of(element, package) is not None for element in pair[1].elts)
    return isinstance(pair[1], ast.Call) and bool(pair[1].args) and _text_of(pair[1].args[0], package) is not None


def _matching(folder: str, target: str, pattern: str) -> Iterator[Installed]:
    if "*" not in pattern and "?" not in pattern:
        yield installed("FILES", target, pattern)
        return
    from glob import escape

    for path in matching(os.path.join(escape(folder), pattern)):
        relative = os.path.relpath(path, folder)
        yield installed("FILES", target, relative)


def _sources_of(node: ast.expr, package: str) -> Iterator[str]:
    """The paths in a list of files, and the patterns in `glob(...)`."""
    if isinstance(node, ast.List):
        for element in node.elts:
            text = _text_of(element, package)
            if text:
                yield text
    elif isinstance(node, ast.Call) and node.args:
        text = _text_of(node.args[0], package)
        if text:
            yield text
    elif isinstance(node, ast.BinOp):
        yield from _sources_of(node.left, package)
        yield from _sources_of(node.right, package)


def _text_of(node: ast.expr, package: str) -> str | None:
    """The value of a path that is a string, `os.path.join(...)`, or contains `package_name`; None for anything else."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else None
    if isinstance(node, ast.Name):
        return package if node.id == "package_name" else None
    parts: list[ast.expr] = []
    separator = ""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "join":
        parts, separator = node.args, "/"
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        parts = [node.left, node.right]
    elif isinstance(node, ast.JoinedStr):
        parts = [value.value if isinstance(value, ast.FormattedValue) else value for value in node.values]
    texts = [_text_of(part, package) for part in parts]
    known = [text for text in texts if text is not None]
    return separator.join(known) if known and len(known) == len(texts) else None
