"""Launch files in Python that ask the environment, or gazebo_ros, where models and plugins are."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, keyword, text_of
from urdfctl.source.span import SourceSpan

_MODULE, _CLASS = "scripts", "GazeboRosPaths"
_NOTHING = '("", "", "")'


def with_default(file: PythonFile, variables: Collection[str]) -> Iterator[Edit]:
    """Yield the edits with which a launch file takes nothing for some variables that are not set.

    Gazebo Classic sets them by its setup.sh; gz has no such file.
    """
    for call, _ in file.calls("EnvironmentVariable"):
        named = keyword(call, "name")
        given = named.value if named is not None else call.args[0] if len(call.args) == 1 else None
        if given is not None and keyword(call, "default_value") is None and text_of(given) in variables:
            end = file.span(given).end
            yield Edit(SourceSpan(file.source, end, end), ', default_value=""')
    for node in ast.walk(file.tree) if file.tree is not None else ():
        if isinstance(node, ast.Subscript) and _reads(node) and text_of(node.slice) in variables:
            opened, closed = file.span(node.value).end, file.span(node).end
            yield Edit(SourceSpan(file.source, opened, opened + 1), ".get(")
            yield Edit(SourceSpan(file.source, closed - 1, closed), ', "")')


def _reads(node: ast.Subscript) -> bool:
    """Whether a variable of the environment is read, and must be set."""
    name = node.value.attr if isinstance(node.value, ast.Attribute) else ""
    return name == "environ" and isinstance(node.ctx, ast.Load)


def without_classic_paths(file: PythonFile) -> Iterator[Edit]:
    """Yield the edits with which a launch file no longer asks gazebo_ros for the paths that packages export.

    The class is in a module that only gazebo_ros installs; gz's launch file looks for these paths itself.
    """
    for node in file.tree.body if file.tree is not None else ():
        if isinstance(node, ast.ImportFrom) and (node.module, [one.name for one in node.names]) == (_MODULE, [_CLASS]):
            span = file.span(node)
            end = file.source.data.find(b"\n", span.end) + 1 or span.end
            yield Edit(SourceSpan(file.source, span.start, end), "")
            yield from (Edit(file.span(call), _NOTHING) for call, _ in file.calls("get_paths"))
