"""Arguments for the world that are empty by default: Gazebo Classic starts its empty world, gz none at all."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, text_of

EMPTY = "empty.sdf"


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


def _called(call: ast.Call) -> str:
    return call.func.id if isinstance(call.func, ast.Name) else getattr(call.func, "attr", "")
