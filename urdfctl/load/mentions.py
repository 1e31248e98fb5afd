"""What the other texts of a workspace say: launch files, programs, scripts and READMEs that were not read."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator

from urdfctl.model.project import Mentioned
from urdfctl.source.disk.files import start_of
from urdfctl.source.disk.gate import walk
from urdfctl.startup.records import NamedTuple

_ENDINGS = (
    *(".launch", ".xml", ".py", ".yaml", ".yml", ".sdf", ".world", ".md", ".rst", ".txt", ".sh", ".bash", ".zsh"),
    *(".bat", ".ps1", ".cpp", ".cc", ".cxx", ".c", ".hpp", ".hh", ".h", ".json", ".ipynb", ".service", ".in"),
    *(".em", ".erb", ".dockerfile", ".mk", ".rs", ".js", ".ts", ".toml", ".repos", ".rosinstall", ".gitmodules"),
)
_LAUNCH_FILES = (".launch", ".launch.xml", ".launch.py")
_OF_BUILDS = frozenset({"package.xml", "CMakeLists.txt", "CHANGELOG.rst", "CHANGELOG.md", "LICENSE"})
"""Files that name programs without starting any."""
_PRUNED = frozenset({"build", "install", "log", "devel", "node_modules", "__pycache__", ".git", ".venv", "meshes"})
_MOST_BYTES = 1 << 18
MOST_FILES = 4000
"""Texts of a workspace that are searched; what more of them say is unknown."""
_MOST_KNOWN = 8


class _Found(NamedTuple):
    """The texts that say something.

    paths: the first of them.
    more: whether there may be others.
    """

    paths: tuple[str, ...]
    more: bool


class Mentions:
    """The texts of workspaces, each searched once for each expression."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str], _Found] = {}

    def beside(self, workspace: str, read: Collection[str]) -> Mentioned:
        """Return a function that returns whether a text of a workspace, other than those that were read, says what a
        regular expression matches; None if that cannot be known, because there are too many.

        Launch files that match the second expression do not count, unless they name one of those that were read.
        """

        def mentioned(expression: str, apart: str = "") -> bool | None:
            known = frozenset(map(os.path.realpath, read))
            key = (workspace, expression)
            if key not in self._found:
                self._found[key] = _search(workspace, expression, known)
            found = self._found[key]
            others = (path for path in found.paths if os.path.realpath(path) not in known)
            is_said = any(not apart or not _is_apart(path, apart, known) for path in others)
            return is_said or (None if found.more else False)

        return mentioned


def _search(workspace: str, expression: str, read: Collection[str]) -> _Found:
    pattern, found = re.compile(expression.encode()), list[str]()
    for count, path in enumerate(_texts(workspace)):
        if count >= MOST_FILES or len(found) > len(read) + _MOST_KNOWN:
            return _Found(tuple(found), more=True)
        try:
            text = start_of(path, _MOST_BYTES)
        except OSError:
            continue
        if pattern.search(text):
            found.append(path)
    return _Found(tuple(found), more=False)


def _is_apart(path: str, expression: str, read: Collection[str]) -> bool:
    """Whether a launch file matches an expression, and includes none of the files that were read."""
    if not path.endswith(_LAUNCH_FILES):
        return False
    try:
        text = start_of(path, _MOST_BYTES)
    except OSError:
        return False
    included = any(os.path.basename(one).encode() in text for one in read if one.endswith(_LAUNCH_FILES))
    return not included and re.search(expression.encode(), text) is not None


def _texts(folder: str) -> Iterator[str]:
    for current, folders, names in walk(folder):
        folders[:] = sorted(name for name in folders if name not in _PRUNED)
        for name in sorted(names):
            if name not in _OF_BUILDS and (name.endswith(_ENDINGS) or "." not in name.lstrip(".")):
                yield os.path.join(current, name)
