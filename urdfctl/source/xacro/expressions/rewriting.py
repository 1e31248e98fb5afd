"""Replace parts of the syntax tree of an expression by calls of guards, which count the work or refuse it."""

from __future__ import annotations

import _ast as ast  # faster to import than ast
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

_GUARDED: dict[type[ast.operator], str] = {ast.Mult: "*", ast.Pow: "**", ast.LShift: "<<", ast.Mod: "%"}
"""Operators that can make much of little, and the names of their guards. The names are not valid in expressions."""
_ADDING: dict[type[ast.operator], str] = {ast.Add: "+", ast.Sub: "-", ast.BitOr: "|", ast.BitAnd: "&", ast.BitXor: "^"}
"""Operators of which only many make much."""
_CALL, _LOOP, _SEARCH, _KEEP = "()", "for", "in", "[]"
GUARDS = (".", *_GUARDED.values(), *_ADDING.values(), _CALL, _LOOP, _SEARCH, _KEEP)
"""The names of what an evaluation is given: see `meter.Meter`."""
_FEW = 10
SOMEWHERE: dict[str, Any] = {"lineno": 1, "col_offset": 0, "end_lineno": 1, "end_col_offset": 0}


Replaced = Mapping[type[ast.AST], Callable[[Any], Any]]
"""Functions that return what replaces a node whose parts are replaced already, by the type of the node."""


def replaced_in(expression: str) -> Replaced:
    """Return what is to be replaced in an expression."""
    return _OF_MANY if _may_make_many(expression) else _ALWAYS


@lru_cache(1)
def arguments() -> ast.arguments:
    """Return the arguments of a function that is given the guards."""
    given = [ast.arg(arg=name, annotation=None, type_comment=None, **SOMEWHERE) for name in GUARDS]
    return ast.arguments(posonlyargs=given, args=[], kwonlyargs=[], kw_defaults=[], defaults=[])


def _operation(node: ast.BinOp) -> ast.expr:
    guard = _GUARDED.get(type(node.op))
    if guard is None or _is_fraction(node.left) or (guard == "*" and _is_fraction(node.right)):
        return node
    return _call(guard, node.left, node.right)


def _one_of_many_operations(node: ast.BinOp) -> ast.expr:
    guard = _ADDING.get(type(node.op))
    if guard is None or _is_number(node.left) or _is_number(node.right):
        return _operation(node)
    return _call(guard, node.left, node.right)


def _attribute(node: ast.Attribute) -> ast.expr:
    return _call(".", node.value, ast.Constant(value=node.attr, kind=None, **SOMEWHERE))


def _counted_call(node: ast.Call) -> ast.expr:
    node.args.insert(0, node.func)
    node.func = ast.Name(id=_CALL, ctx=ast.Load(), **SOMEWHERE)
    return node


def _subscript(node: ast.Subscript) -> ast.expr:
    return _kept(node) if isinstance(node.slice, ast.Slice) else node


def _starred(node: ast.Starred) -> ast.expr:
    node.value = _call(_LOOP, node.value)
    return node


def _formatted(node: ast.FormattedValue) -> ast.expr:
    node.value = _kept(node.value)
    return node


def _dict(node: ast.Dict) -> ast.expr:
    pairs = zip(node.keys, node.values, strict=True)
    node.values = [_call(_LOOP, value) if key is None else value for key, value in pairs]
    return node


def _membership(node: ast.Compare) -> ast.expr:
    for index, operator in enumerate(node.ops):
        if isinstance(operator, (ast.In, ast.NotIn)):
            node.comparators[index] = _call(_SEARCH, node.comparators[index])
    return node


def _loop(node: ast.comprehension) -> ast.comprehension:
    node.iter = _call(_LOOP, node.iter)
    return node


def _comprehension(node: ast.ListComp | ast.SetComp | ast.GeneratorExp) -> ast.expr:
    node.elt = _kept(node.elt)
    return node


def _dict_comprehension(node: ast.DictComp) -> ast.expr:
    node.key, node.value = _kept(node.key), _kept(node.value)
    return node


def _one_of_many_lists(node: ast.List | ast.Tuple | ast.Set) -> ast.expr:
    is_target = isinstance(getattr(node, "ctx", None), ast.Store)
    return node if is_target else _kept(node)


def _one_of_many_comparisons(node: ast.Compare) -> ast.expr:
    node.left = _kept(node.left)
    return _membership(node)


_ALWAYS: Replaced = {
    ast.BinOp: _operation,
    ast.Attribute: _attribute,
    ast.Call: _counted_call,
    ast.Subscript: _subscript,
    ast.Starred: _starred,
    ast.FormattedValue: _formatted,
    ast.Dict: _dict,
    ast.Compare: _membership,
    ast.comprehension: _loop,
    ast.ListComp: _comprehension,
    ast.SetComp: _comprehension,
    ast.GeneratorExp: _comprehension,
    ast.DictComp: _dict_comprehension,
}
_OF_MANY: Replaced = {
    **_ALWAYS,
    ast.BinOp: _one_of_many_operations,
    ast.List: _one_of_many_lists,
    ast.Tuple: _one_of_many_lists,
    ast.Set: _one_of_many_lists,
    ast.Dict: lambda node: _kept(_dict(node)),
    ast.Compare: _one_of_many_comparisons,
}
"""What is replaced besides in an expression that repeats parts of it, or has many operators."""


def _may_make_many(expression: str) -> bool:
    if "for" in expression or "lambda" in expression:
        return True
    return len(expression) > 2 * _FEW and sum(map(expression.count, _ADDING.values())) > _FEW


def _kept(node: ast.expr) -> ast.expr:
    return _call(_KEEP, node)


def _call(guard: str, *arguments: ast.expr) -> ast.expr:
    name = ast.Name(id=guard, ctx=ast.Load(), **SOMEWHERE)
    return ast.Call(func=name, args=list(arguments), keywords=[], **SOMEWHERE)


def _is_fraction(node: ast.expr) -> bool:
    """Return whether a node is certainly a float, which neither grows nor repeats anything."""
    if isinstance(node, ast.Constant):
        return isinstance(node.value, float)
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div)


def _is_number(node: ast.expr) -> bool:
    """Return whether a node is certainly a number, to which only another number can be added."""
    return _is_fraction(node) or (isinstance(node, ast.Constant) and isinstance(node.value, int | complex))
