"""What the other texts of a workspace say: launch files, programs, scripts and READMEs that were not read."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator

from urdfctl.model.project import Mentioned
from urdfctl.source.disk.files import start_of
from urdfctl.source.disk.gate import walk
from urdfctl.source.workspaces.packages import package_around

_ENDINGS = (
    *(".launch", ".xml", ".py", ".yaml", ".yml", ".sdf", ".world", ".md", ".rst", ".txt", ".sh", ".bash", ".zsh"),
    *(".bat", ".ps1", ".cpp", ".cc", ".cxx", ".c", ".hpp", ".hh", ".h", ".json", ".ipynb", ".service", ".in"),
    *(".em", ".erb", ".dockerfile", ".mk", ".rs", ".js", ".ts", ".toml", ".repos", ".rosinstall", ".gitmodules"),
)
_OF_BUILDS = (
    *(".repos", ".repos.yaml", ".rosinstall", ".gitmodules", ".yml", ".md", ".rst", ".txt", ".sh", ".bash"),
    *(".dockerfile", ".mk"),
)
"""Ends of the names of texts that say how a workspace is made; so do names without an end, such as Dockerfile."""
_LAUNCH_FILES = (".launch", ".launch.xml", ".launch.py")
_STARTING_NOTHING = frozenset({"package.xml", "CMakeLists.txt", "CHANGELOG.rst", "CHANGELOG.md", "LICENSE"})
"""Files that name programs without starting any."""
_PRUNED = frozenset({"build", "install", "log", "devel", "node_modules", "__pycache__", "meshes"})
_MOST_BYTES = 1 << 18
MOST_FILES = 4000
"""Texts of a workspace that are searched; what more of them say is unknown."""
_SHOWN = frozenset({".github", ".gitlab", ".circleci", ".devcontainer", ".docker"})
"""The hidden folders that a person writes; others hold what tools keep."""


class _TextSearch:
    """The texts of a workspace that match an expression, found as far as they were asked for.

    is_whole: whether all texts were searched: there may be too many, and a search may be interrupted.
    """

    def __init__(self, texts: Iterator[str], expression: str) -> None:
        self._left = self._matching(texts, expression)
        self._found: list[str] = []
        self.is_whole = False

    def paths(self) -> Iterator[str]:
        yield from self._found
        for path in self._left:
            self._found.append(path)
            yield path

    def _matching(self, texts: Iterator[str], expression: str) -> Iterator[str]:
        pattern = re.compile(expression.encode())
        for count, path in enumerate(texts):
            if count >= MOST_FILES:
                return
            try:
                text = start_of(path, _MOST_BYTES)
            except OSError:
                continue
            if pattern.search(text):
                yield path
        self.is_whole = True


class Mentions:
    """The texts of workspaces, each searched once for each expression."""

    def __init__(self) -> None:
        self._searches: dict[tuple[str, str, frozenset[str | None] | None], _TextSearch] = {}

    def beside(self, workspace: str, read: Collection[str]) -> Mentioned:
        """Return a function that returns whether a text of a workspace, other than those that were read, says what a
        regular expression matches; None if that cannot be known, because there are too many.

        Launch files that match the second expression do not count, unless they name one of those that were read.
        """

        def mentioned(expression: str, apart: str = "", *, of_builds: bool = False) -> bool | None:
            known = frozenset(map(os.path.realpath, read))
            around = frozenset(map(package_around, map(os.path.dirname, read))) if of_builds else None
            texts = _texts(workspace, _ENDINGS) if around is None else _texts(workspace, _OF_BUILDS, packages=around)
            search = self._searches.setdefault((workspace, expression, around), _TextSearch(texts, expression))
            others = (path for path in search.paths() if os.path.realpath(path) not in known)
            is_said = any(not apart or not _is_apart(path, apart, known) for path in others)
            return is_said or (False if search.is_whole else None)

        return mentioned


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


def _texts(workspace: str, endings: tuple[str, ...], packages: Collection[str | None] | None = None) -> Iterator[str]:
    """The texts of a workspace with such names.

    packages: those that are searched whole; of others only what is beside their package.xml. None for all.
    """
    for current, folders, names in walk(workspace):
        is_whole = packages is None or "package.xml" not in names or current in packages or current == workspace
        if not is_whole:
            folders[:] = _SHOWN.intersection(folders)
        folders[:] = sorted(name for name in folders if name not in _PRUNED and (name[0] != "." or name in _SHOWN))
        for name in sorted(names):
            if name not in _STARTING_NOTHING and (name.endswith(endings) or "." not in name.lstrip(".")):
                yield os.path.join(current, name)
