"""What a launch file in Python certainly evaluates, and the names in it that nothing in the file defines."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterable, Iterator
from itertools import chain

_GIVEN = frozenset({*dir(builtins), "__file__", "__path__", "__builtins__", "__annotations__"})
_HIDING = frozenset({"exec", "eval", "globals", "locals", "vars", "setattr"})
"""Functions that may define names in ways that the text does not show."""
_LATER = (ast.Lambda, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp, ast.NamedExpr)
"""Expressions of which not all is evaluated, or which define names."""


def unbound_name(tree: ast.Module, nodes: Iterable[ast.AST], entry: str) -> ast.Name | None:
    """Return the first name that Python does not find when a launch file is started; None if it finds all that it
    certainly looks up.

    A name that the file defines anywhere counts as defined.

    nodes: all of the file's.
    entry: the name of the function that is called.
    """
    known = set(_GIVEN)
    for node in nodes:
        names = _defined(node)
        if names is None:
            return None
        known.update(names)
    names_read = (part for part in evaluated(tree, entry) if isinstance(part, ast.Name))
    return next((name for name in names_read if name.id not in known), None)


def evaluated(tree: ast.Module, entry: str) -> Iterator[ast.expr]:
    """Yield the expressions that are certainly evaluated when a launch file is started.

    entry: the name of the function that is called.
    """
    function = entry_function(tree, entry)
    return chain(_evaluated(tree.body), _evaluated(function.body if function else ()))


def entry_function(tree: ast.Module, entry: str) -> ast.FunctionDef | None:
    """Return the function that launch calls; None if it is not there, or if a decorator may replace it."""
    function = next((one for one in tree.body if isinstance(one, ast.FunctionDef) and one.name == entry), None)
    return function if function and not function.decorator_list else None


def _defined(node: ast.AST) -> Iterable[str] | None:
    """The names that a node defines; None if it may define any."""
    if isinstance(node, ast.Name):
        return None if node.id in _HIDING else () if isinstance(node.ctx, ast.Load) else (node.id,)
    if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
        return (node.name,)
    if isinstance(node, ast.arg):
        return (node.arg,)
    if isinstance(node, ast.alias):
        return None if node.name == "*" else (node.asname or node.name.partition(".")[0],)
    if isinstance(node, (ast.Global, ast.Nonlocal)):
        return node.names
    name = getattr(node, "name", None) or getattr(node, "rest", None)  # of handlers and of patterns
    return (name,) if isinstance(name, str) else ()


def _evaluated(statements: Iterable[ast.stmt]) -> Iterator[ast.expr]:
    """Yield what is evaluated if statements run one after the other, as far as that is certain."""
    for statement in statements:
        if isinstance(statement, (ast.Assign, ast.AnnAssign, ast.AugAssign, ast.Expr, ast.Return)):
            yield from _parts(statement.value)
        elif isinstance(statement, ast.If):
            yield from _parts(statement.test)
        elif isinstance(statement, ast.For):
            yield from _parts(statement.iter)
        elif isinstance(statement, ast.With):
            yield from (part for item in statement.items for part in _parts(item.context_expr))
        if not isinstance(statement, (*_SIMPLE, *_COMPOUND)) or _may_leave(statement):
            return


_SIMPLE = (
    *(ast.Assign, ast.AnnAssign, ast.AugAssign, ast.Expr, ast.Import, ast.ImportFrom, ast.FunctionDef, ast.ClassDef),
    *(ast.Pass, ast.Assert, ast.Delete),
)
_COMPOUND = (ast.If, ast.For, ast.With)


def _may_leave(statement: ast.stmt) -> bool:
    """Whether the statements after another one may not run."""
    if not isinstance(statement, _COMPOUND):
        return False
    return any(isinstance(node, (ast.Return, ast.Raise)) for node in ast.walk(statement))


def _parts(expression: ast.expr | None) -> Iterator[ast.expr]:
    """Yield an expression and the expressions in it that are evaluated whatever they are."""
    if expression is None or isinstance(expression, _LATER):
        return
    yield expression
    if isinstance(expression, ast.IfExp):
        yield from _parts(expression.test)
    elif isinstance(expression, ast.BoolOp):
        yield from _parts(expression.values[0])
    else:
        for child in ast.iter_child_nodes(expression):
            inner = child.value if isinstance(child, ast.keyword) else child
            if isinstance(inner, ast.expr):
                yield from _parts(inner)
