"""Compile expressions in `${...}` and `$(eval ...)`: what is not on the allow-list is refused, and what could make a
small expression endless becomes calls of guards.
"""

from __future__ import annotations

import _ast as ast  # faster to import than ast
import re
import warnings
from functools import lru_cache
from keyword import iskeyword
from types import CodeType
from typing import Any

from urdfctl.source.xacro.expressions.allowed import check
from urdfctl.source.xacro.expressions.guards import ForbiddenExpression
from urdfctl.source.xacro.expressions.rewriting import GUARDS, SOMEWHERE, Replaced, arguments, replaced_in

__all__ = ["GUARDS", "ForbiddenExpression", "compile_checked", "plain_path"]

_LONGEST = 10_000
_DEEPEST = 500
_TOO_DEEP = f"the expression is nested more than {_DEEPEST} levels deep"
_WITH_PARTS = (ast.expr, ast.comprehension, ast.arguments, ast.arg, ast.keyword)
_QUOTED = r"'[^'\\\n]*'|\"[^\"\\\n]*\""
_STEP = re.compile(rf"[A-Za-z]\w*|{_QUOTED}")
_PATH = re.compile(rf"[A-Za-z]\w*(?:\[(?:{_QUOTED})\])*", re.ASCII)


@lru_cache(8192)
def compile_checked(expression: str, *, function: bool = False) -> CodeType:
    """Return the code of an expression.

    function: return a function instead, whose arguments are the guards of GUARDS, in their order.
    Raises ForbiddenExpression if it is not on the allow-list, SyntaxError if it is not an expression.
    """
    if len(expression) > _LONGEST:
        raise ForbiddenExpression(f"the expression is longer than {_LONGEST} characters")
    tree = _guarded(_parsed(expression), _DEEPEST, replaced_in(expression))
    if not function:
        return _compiled(tree)
    outer = _compiled(ast.Expression(body=ast.Lambda(args=arguments(), body=tree.body, **SOMEWHERE)))
    return next(constant for constant in outer.co_consts if isinstance(constant, CodeType))


def _compiled(tree: Any) -> CodeType:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about the style of an expression such as 1["a"], which is not the user's
        code: CodeType = compile(tree, "<expression>", "eval")
    return code


def _parsed(expression: str) -> ast.AST:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return compile(expression, "<expression>", "eval", ast.PyCF_ONLY_AST, dont_inherit=True)
    except (RecursionError, MemoryError):  # Python's parser raises either for deep nesting
        raise ForbiddenExpression(_TOO_DEEP) from None


@lru_cache(8192)
def plain_path(expression: str) -> tuple[str, ...] | None:
    """Return the name and the keys of an expression such as `a` or `a['b']['c']`, which needs no code; None for others.

    Nine of ten expressions are such in a robot that reads its numbers from YAML.
    """
    if len(expression) > _LONGEST or "__" in expression or not _PATH.fullmatch(expression):
        return None
    name, *keys = _STEP.findall(expression)
    return None if iskeyword(name) else (name, *(key[1:-1] for key in keys))


def _guarded(node: Any, depth: int, replaced: Replaced, *, called: bool = False) -> Any:
    """Return a checked tree with calls of guards instead of what is to be replaced. ForbiddenExpression if it is not
    allowed, or too deep.
    """
    if depth == 0:
        raise ForbiddenExpression(_TOO_DEEP)
    check(node, called=called)
    for field in node._fields:
        value = getattr(node, field)
        if isinstance(value, _WITH_PARTS):
            setattr(node, field, _guarded(value, depth - 1, replaced, called=field == "func"))
        elif isinstance(value, list):
            value[:] = [
                _guarded(part, depth - 1, replaced) if isinstance(part, _WITH_PARTS) else part for part in value
            ]
    replace = replaced.get(type(node))
    return replace(node) if replace else node
