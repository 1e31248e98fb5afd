"""Expressions of `$(eval)` in ROS 1 as expressions in which the text of an argument replaces its name.

roslaunch gives an expression the arguments as names and by `arg()`, with their types: booleans, numbers and strings.
Launch files of ROS 2 put the text of the argument into the expression. `true`, `false`, the names of `math` and the
functions `find`, `env`, `optenv` and `dirname` are no arguments (roslib substitution_args.py: _eval_dict).
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Iterator

from urdfctl.startup.records import NamedTuple

_TRUE = "('{}'.lower() == 'true')"
_BY_CALL = r"arg\(\s*['\"](\w+)['\"]\s*\)"


_CONSTANTS = {"true": "True", "false": "False"}
_GIVEN = frozenset({*vars(math), "list", "dict", "map", "str", "float", "int"})
"""Names that expressions of roslaunch and of ROS 2's PythonExpression both know."""
_FUNCTIONS = {"find": "find", "env": "env", "optenv": "env", "dirname": "dirname"}
"""The kinds of the substitutions for functions of an expression."""


class Used(NamedTuple):
    """A substitution in an expression, between the texts before and after it, which belong to its value.

    kind, default: see `PartOfText`.
    """

    before: str
    name: str
    after: str
    kind: str = "arg"
    default: str | None = None


class _Place(NamedTuple):
    """What replaces a part of an expression, between two offsets in its bytes."""

    start: int
    stop: int
    new: str | Used


def parts_of(expression: str) -> list[str | Used]:
    """Return the texts of an expression of ROS 1, and the substitutions between them."""
    try:
        tree = ast.parse(expression, mode="eval")
    except (SyntaxError, ValueError, RecursionError):
        return _by_call(expression)
    data = expression.encode()
    parts: list[str | Used] = []
    end = 0
    for place in sorted(_places(tree.body, None)):
        parts += [data[end : place.start].decode(), place.new]
        end = place.stop
    return [part for part in (*parts, data[end:].decode()) if part]


def _by_call(expression: str) -> list[str | Used]:
    pieces = re.split(_BY_CALL, expression)
    parts = [Used("'", piece, "'") if index % 2 else piece for index, piece in enumerate(pieces)]
    return [part for part in parts if part]


def _places(node: ast.AST, around: ast.AST | None) -> Iterator[_Place]:
    """Yield the parts below a node that have another form in ROS 2."""
    default = _default_of_variable(node)
    if default is not None and isinstance(node, ast.Call) and node.end_col_offset is not None:
        name = str(node.args[0].value) if isinstance(node.args[0], ast.Constant) else ""
        yield _Place(node.col_offset, default.col_offset, Used("('", name, "' or (", "env", ""))
        yield from _places(default, None)
        yield _Place(node.end_col_offset - 1, node.end_col_offset, "))")
        return
    new = _replaced(node, around)
    if new is not None and isinstance(node, ast.expr) and node.end_col_offset is not None:
        yield _Place(node.col_offset, node.end_col_offset, new)
        return
    for child in ast.iter_child_nodes(node):
        is_called = isinstance(node, ast.Call) and child is node.func and isinstance(child, ast.Name)
        if not is_called:
            yield from _places(child, node)


def _default_of_variable(node: ast.AST) -> ast.expr | None:
    """The default of a variable of the environment, `optenv(name, default)`, that is an expression; else None."""
    is_call = isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "optenv"
    name, *others = [*(node.args if isinstance(node, ast.Call) and is_call else []), None]
    default = others[0] if others else None
    is_expression = isinstance(name, ast.Constant) and not isinstance(default, ast.Constant)
    return default if is_expression else None


def _replaced(node: ast.AST, around: ast.AST | None) -> str | Used | None:
    """What replaces a node; None if it stays."""
    if isinstance(node, ast.Name) and (node.id in _CONSTANTS or node.id in _GIVEN):
        return _CONSTANTS.get(node.id)
    function = node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
    if function in _FUNCTIONS and isinstance(node, ast.Call):
        texts = [str(one.value) for one in node.args if isinstance(one, ast.Constant)]
        name, default = [*texts, "", ""][:2]
        return Used("'", name, "'", _FUNCTIONS[function], default if function == "optenv" else None)
    name = _argument(node)
    if not name or not isinstance(node, ast.expr):
        return None
    before, after = _form(node, around).split("{}")
    return Used(before, name, after)


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
    is_bool = any(isinstance(other, ast.Name) and other.id in _CONSTANTS for other in others)
    if is_bool or any(isinstance(value, bool) for value in values):
        return _TRUE
    return "{}" if any(isinstance(value, (int, float)) for value in values) else "'{}'"
