"""Actions that a launch file in Python creates and never uses."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Sequence

_ACTIONS = frozenset(
    (
        "AppendEnvironmentVariable ComposableNodeContainer DeclareLaunchArgument ExecuteProcess GroupAction "
        "IncludeLaunchDescription LifecycleNode LoadComposableNodes Node OpaqueFunction PushRosNamespace "
        "RegisterEventHandler RosGzBridge SetEnvironmentVariable SetParameter SetRemap TimerAction"
    ).split()
)
"""Classes whose objects have an effect only if launch gets them."""
_SHOWING = frozenset({"eval", "exec", "globals", "locals", "vars"})
"""Functions that may use any name."""


def unused_actions(nodes: Sequence[ast.AST], text: str) -> Iterator[ast.Name]:
    """Yield the names of actions that functions of a launch file create, and that nothing in the file uses.

    Who made a comment of the use wants the action off; such names are not told.

    nodes: all of the file's.
    """
    used = {node.id for node in nodes if type(node) is ast.Name and type(node.ctx) is not ast.Store}
    if used & _SHOWING:
        return
    for function in nodes:
        if type(function) is ast.FunctionDef:
            for statement in function.body:
                name = _created(statement)
                if name and name.id not in used and not re.search(rf"#.*\b{re.escape(name.id)}\b", text):
                    yield name


def _created(statement: ast.stmt) -> ast.Name | None:
    """The name that a statement gives to a new action."""
    if not isinstance(statement, ast.Assign) or not isinstance(statement.value, ast.Call):
        return None
    function, (target, *others) = statement.value.func, statement.targets
    called = function.id if isinstance(function, ast.Name) else getattr(function, "attr", "")
    return target if isinstance(target, ast.Name) and not others and called in _ACTIONS else None
