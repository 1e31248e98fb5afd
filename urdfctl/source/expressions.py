"""What an expression in `${...}` or `$(eval ...)` may do: an allow-list over its syntax tree.

xacro's own check looks at the top-level names only; a lambda, a comprehension, `$(eval ...)` or `str.format` escape it.
Here no attribute that begins with an underscore can be reached, nor one that leads from a value to the interpreter.
"""

from __future__ import annotations

import ast
import re
from functools import lru_cache
from types import CodeType

_ALLOWED: tuple[type[ast.AST], ...] = (
    ast.Expression, ast.BoolOp, ast.BinOp, ast.UnaryOp, ast.IfExp, ast.Compare, ast.Call, ast.keyword, ast.Starred,
    ast.Constant, ast.Dict, ast.Set, ast.List, ast.Tuple, ast.Subscript, ast.Slice, ast.Name, ast.Attribute,
    ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp, ast.comprehension, ast.Lambda, ast.arguments, ast.arg,
    ast.JoinedStr, ast.FormattedValue, ast.expr_context, ast.boolop, ast.operator, ast.unaryop, ast.cmpop,
)  # fmt: skip
_FORBIDDEN_ATTRIBUTES = frozenset(
    (
        "gi_frame gi_code gi_yieldfrom cr_frame cr_code cr_await cr_origin ag_frame ag_code ag_await f_back "
        "f_globals f_locals f_builtins f_code f_trace tb_frame tb_next tb_lasti func_globals func_code "
        "co_code co_consts co_names mro format_map vars with_traceback"
    ).split()
)
_DOTTED_FIELD = r"\{[^}]*[.\[]"
_LONGEST = 10_000


class ForbiddenExpression(Exception):
    """An expression does what none in a robot description needs."""


@lru_cache(8192)
def compile_checked(expression: str) -> CodeType:
    """The code of an expression. ForbiddenExpression where it leaves the allow-list, SyntaxError where it is none."""
    if len(expression) > _LONGEST:
        raise ForbiddenExpression(f"the expression is longer than {_LONGEST} characters")
    tree = ast.parse(expression, "<expression>", "eval")
    for node in ast.walk(tree):
        _check(node)
    return compile(tree, "<expression>", "eval")


def _check(node: ast.AST) -> None:
    if not isinstance(node, _ALLOWED):
        raise ForbiddenExpression(f"{type(node).__name__} is not allowed in an expression")
    if isinstance(node, ast.Attribute):
        _check_attribute(node)
    elif isinstance(node, ast.Name) and (node.id.startswith("__") or node.id == "vars"):
        raise ForbiddenExpression(f"the name '{node.id}' is not allowed in an expression")
    elif isinstance(node, ast.Constant) and isinstance(node.value, str) and _is_dunder(node.value):
        raise ForbiddenExpression(f"the text '{node.value}' is not allowed in an expression")


def _is_dunder(text: str) -> bool:
    return text.startswith("__") and text.endswith("__") and bool(text.strip("_"))


def _check_attribute(node: ast.Attribute) -> None:
    name = node.attr
    if name.startswith("_") or name in _FORBIDDEN_ATTRIBUTES:
        raise ForbiddenExpression(f"the attribute '{name}' is not allowed in an expression")
    if name == "format":
        template = node.value
        plain = isinstance(template, ast.Constant) and isinstance(template.value, str)
        if not plain or re.search(_DOTTED_FIELD, template.value):  # type: ignore[attr-defined]
            raise ForbiddenExpression("'format' of a computed or dotted format text is not allowed in an expression")
