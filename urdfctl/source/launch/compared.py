"""Launch arguments that a launch file in Python compares, or takes for true or false, before they have a value."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator, Sequence

from urdfctl.startup.records import NamedTuple

_CLASS = "LaunchConfiguration"
_ASKING = frozenset({ast.Compare, ast.UnaryOp, ast.If, ast.IfExp, ast.While})


class ComparedArgument(NamedTuple):
    """Where an expression has the substitution for a launch argument in the place of its value.

    gives: what the expression gives whatever the value is.
    """

    at: ast.expr
    gives: bool


def compared_arguments(nodes: Sequence[ast.AST]) -> Iterator[ComparedArgument]:
    """Yield the comparisons and conditions of a file that do not depend on the value that they seem to ask for.

    nodes: all of the file's.
    """
    asking = [node for node in nodes if type(node) in _ASKING]
    known = _substitutions(nodes) if asking else set()
    for node in asking:
        if isinstance(node, ast.Compare):
            gives = _compared(node, known) if len(node.ops) == 1 else None
            if gives is not None:
                yield ComparedArgument(node, gives)
        elif isinstance(node, ast.UnaryOp):
            if isinstance(node.op, ast.Not) and _is_substitution(node.operand, known):
                yield ComparedArgument(node, gives=False)
        elif isinstance(node, (ast.If, ast.IfExp, ast.While)) and _is_substitution(node.test, known):
            yield ComparedArgument(node.test, gives=True)


def _compared(node: ast.Compare, known: Collection[str]) -> bool | None:
    """What a comparison of a substitution with a value gives; None if it is none."""
    left, operator, right = node.left, node.ops[0], node.comparators[0]
    is_sided = _is_substitution(left, known) and isinstance(right, ast.Constant)
    if isinstance(operator, (ast.Eq, ast.NotEq)):
        is_sided = is_sided or (_is_substitution(right, known) and isinstance(left, ast.Constant))
        return isinstance(operator, ast.NotEq) if is_sided else None
    if isinstance(operator, (ast.In, ast.NotIn)) and _is_substitution(left, known):
        values = right.elts if isinstance(right, (ast.List, ast.Tuple, ast.Set)) else ()
        return isinstance(operator, ast.NotIn) if values and all(isinstance(e, ast.Constant) for e in values) else None
    return None


def _is_substitution(node: ast.expr, known: Collection[str]) -> bool:
    if isinstance(node, ast.Name):
        return node.id in known
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == _CLASS


def _substitutions(nodes: Sequence[ast.AST]) -> set[str]:
    """The names that are a substitution wherever they are bound."""
    bound = {node.arg for node in nodes if isinstance(node, ast.arg)}
    made: set[str] = set()
    for node in nodes:
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            (made if _is_substitution(node.value, ()) else bound).add(node.targets[0].id)
    assigned = [node.id for node in nodes if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)]
    return {name for name in made - bound if assigned.count(name) == 1}
