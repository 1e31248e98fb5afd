"""The empty world of Gazebo Classic, which gz has by another name: as a path, and where no world is named."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, text_of

EMPTY = "empty.sdf"
_OF_CLASSIC, _WORLD = "gazebo_ros", "empty.world"
_JOINS = ("join", "PathJoinSubstitution")


def reached(file: PythonFile, nodes: Sequence[ast.AST], scope: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes of expressions, and of the values of the names in them."""
    pending = list(nodes)
    seen: set[str] = set()
    while pending:
        node = pending.pop()
        yield node
        pending += ast.iter_child_nodes(node)
        if isinstance(node, ast.Name) and node.id not in seen:
            seen.add(node.id)
            value = file.value_of(node, scope)
            pending += [] if value is node else [value]


def filled_defaults(file: PythonFile, world: ast.expr, scope: ast.AST) -> Iterator[Edit]:
    """Yield the edits of empty defaults of the arguments that say which world is started."""
    calls = (node for node in reached(file, [world], scope) if isinstance(node, ast.Call))
    names = {text_of(call.args[0]) for call in calls if call.args and _called(call) == "LaunchConfiguration"}
    for call, _ in file.calls("DeclareLaunchArgument"):
        default = keyword(call, "default_value")
        is_empty = default is not None and isinstance(default.value, ast.Constant) and default.value.value == ""
        if default is not None and is_empty and call.args and text_of(call.args[0]) in names:
            yield Edit(file.span(default.value), f'"{EMPTY}"')


def empty_world_paths(file: PythonFile) -> Iterator[tuple[ast.expr, bool]]:
    """Yield the expressions that join parts to a path of a world with the name of Gazebo Classic's empty one, and
    whether it is that: gz finds its own by its name alone. A file of another package keeps its name."""
    pending: list[tuple[ast.AST, ast.AST]] = [(file.tree, file.tree)] if file.tree else []
    while pending:
        node, scope = pending.pop()
        if isinstance(node, ast.expr) and (parts := _joined(node)):
            end = text_of(parts[-1])
            if end.rpartition("/")[2] == _WORLD:
                texts = {text_of(one) for one in reached(file, parts, scope) if isinstance(one, ast.Constant)}
                is_plain = all(isinstance(one, ast.Constant) for one in parts)
                yield node, is_plain or _OF_CLASSIC in texts
                continue
        inner = node if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)) else scope
        pending += [(child, inner) for child in ast.iter_child_nodes(node)]


def _joined(node: ast.expr) -> list[ast.expr]:
    """The parts that an expression joins to a path; empty if it joins none."""
    if isinstance(node, ast.Call) and _called(node) in _JOINS:
        first = node.args[0] if node.args else None
        return first.elts if isinstance(first, ast.List) else node.args
    if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Div)):
        return [node.left, node.right]
    is_path = isinstance(node, ast.List) and any(isinstance(one, ast.Call) for one in node.elts[:1])
    return node.elts if isinstance(node, ast.List) and is_path else []


def _called(call: ast.Call) -> str:
    return call.func.id if isinstance(call.func, ast.Name) else getattr(call.func, "attr", "")
