"""The Python modules of the workspace that launch files import. They are read as text, like launch files."""

from __future__ import annotations

from collections.abc import Callable

from urdfctl.source.launch.frames import Frame
from urdfctl.source.launch.terms import Constant, Function, Items, OwnClass, OwnObject, Table, Term
from urdfctl.source.span import SourceText

_KNOWN = frozenset(
    (
        "launch launch_ros ament_index_python xacro yaml os sys pathlib re math typing moveit_configs_utils "
        "nav2_common controller_manager launch_param_builder launch_testing launch_xml launch_yaml rclpy "
        "json subprocess tempfile"
    ).split()
)
"""Modules whose functions and classes are known by name."""
_MOST_MODULES = 20


class Modules:
    """The modules that one launch file imports.

    find: returns the text of a module by its name and the file that imports it; None if it is not in the workspace.
    follow: returns the names of a module after its statements; None if it cannot be read.
    """

    def __init__(
        self,
        find: Callable[[str, str], SourceText | None],
        follow: Callable[[SourceText], Frame | None],
    ) -> None:
        self._find = find
        self._follow = follow
        self._frames: dict[str, Frame | None] = {}

    def member(self, path: str, importer: str) -> Term | None:
        """Return what a full name, such as `package.module.function`, means; None if it is not of the workspace."""
        module, _, name = path.rpartition(".")
        if not module or path.partition(".")[0] in _KNOWN:
            return None
        frame = self._frame(module, importer)
        term = frame.names.get(name) if frame else None
        return term if isinstance(term, (Function, Constant, Items, Table, OwnClass, OwnObject)) else None

    def _frame(self, module: str, importer: str) -> Frame | None:
        source = self._find(module, importer) if len(self._frames) < _MOST_MODULES else None
        if source is None:
            return None
        if source.path not in self._frames:
            self._frames[source.path] = None  # for modules that import each other
            self._frames[source.path] = self._follow(source)
        return self._frames[source.path]
