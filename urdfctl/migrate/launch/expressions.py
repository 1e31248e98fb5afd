"""Expressions of `$(eval)` in ROS 1 as expressions in which the text of an argument replaces its name.

roslaunch gives an expression the arguments as names and by `arg()`, with their types: booleans, numbers and strings.
Launch files of ROS 2 put the text of the argument into the expression.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from urdfctl.startup.records import NamedTuple

_TRUE = "('{}'.lower() == 'true')"
_BY_CALL = r"arg\(\s*['\"](\w+)['\"]\s*\)"


class Used(NamedTuple):
    """An argument in an expression, between the texts before and after it, which belong to its value."""

    before: str
    name: str
    after: str


def parts_of(expression: str) -> list[str | Used]:
    """Return the texts of an expression of ROS 1, and the arguments between them."""
    try:
        tree = ast.parse(expression, mode="eval")
    except (SyntaxError, ValueError, RecursionError):
        return _by_call(expression)
    uses = sorted(_uses(tree.body, None), key=lambda use: use[0])
    data = expression.encode()
    parts: list[str | Used] = []
    end = 0
    for start, stop, name, form in uses:
        before, after = form.split("{}")
        parts += [data[end:start].decode(), Used(before, name, after)]
        end = stop
    return [part for part in (*parts, data[end:].decode()) if part]


def _by_call(expression: str) -> list[str | Used]:
    pieces = re.split(_BY_CALL, expression)
    parts = [Used("'", piece, "'") if index % 2 else piece for index, piece in enumerate(pieces)]
    return [part for part in parts if part]


def _uses(node: ast.AST, around: ast.AST | None) -> Iterator[tuple[int, int, str, str]]:
    """Yield the arguments below a node: their offsets and names, and the form in which their text is put there."""
    name = _argument(node)
    if name and isinstance(node, ast.expr) and node.end_col_offset is not None:
        yield node.col_offset, node.end_col_offset, name, _form(node, around)
        return
    for child in ast.iter_child_nodes(node):
        is_called = isinstance(node, ast.Call) and child is node.func and isinstance(child, ast.Name)
        if not is_called:
            yield from _uses(child, node)


def _argument(node: ast.AST) -> str:
    """The name of the argument that a node means; empty if it means none."""
    if isinstance(node, ast.Name):
        return node.id
    is_call = isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "arg"
    first = node.args[0] if isinstance(node, ast.Call) and is_call and node.args else None
    return str(first.value) if isinstance(first, ast.Constant) else ""


def _form(node: ast.expr, around: ast.AST | None) -> str:
    """How the text of an argument is put into an expression, `{}` for the text: as truth, number or string."""
    if isinstance(around, (ast.BoolOp, ast.UnaryOp)) or (isinstance(around, ast.IfExp) and around.test is node):
        return _TRUE
    others = [around.left, *around.comparators] if isinstance(around, ast.Compare) else []
    others += [around.left, around.right] if isinstance(around, ast.BinOp) else []
    values = [other.value for other in others if isinstance(other, ast.Constant)]
    if any(isinstance(value, bool) for value in values):
        return _TRUE
    return "{}" if any(isinstance(value, (int, float)) for value in values) else "'{}'"
