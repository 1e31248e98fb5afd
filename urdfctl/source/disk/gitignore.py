"""Find the files that git ignores: read .gitignore files and .git/info/exclude of a repository."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from fnmatch import fnmatchcase

from urdfctl.source.disk import gate
from urdfctl.source.disk.files import first_bytes, folders_upwards
from urdfctl.startup.records import NamedTuple

_MOST_BYTES = 1 << 20


class IgnorePattern(NamedTuple):
    """A line of a .gitignore.

    parts: the pattern's parts between slashes; `**` matches any folders.
    ignores: False for a line with `!`, which includes again.
    only_folders: True if the line ends with a slash.
    anywhere: True if the line has no other slash: it matches names in any folder.
    """

    parts: tuple[str, ...]
    ignores: bool
    only_folders: bool
    anywhere: bool

    def matches(self, path: Sequence[str], *, is_folder: bool) -> bool:
        """Return whether the pattern matches a path, given as parts relative to the .gitignore's folder."""
        if self.only_folders and not is_folder:
            return False
        return _matches_name(path[-1], self.parts[0]) if self.anywhere else _matches_parts(path, self.parts)


class GitIgnore:
    """The files and folders that git ignores below one folder; none if the folder is not in a repository.

    Each .gitignore is read once. Callers do not ask for files in ignored folders.
    """

    def __init__(self, folder: str, top: str | None = None) -> None:
        """Read the .gitignore files up to the repository's folder; without a repository up to the folder `top`."""
        self._top = _repository(os.path.realpath(folder)) or (top and os.path.realpath(top))
        self._real: dict[str, str] = {}
        self._applying: dict[str, list[_Applying]] = {}

    def ignores(self, path: str, *, is_folder: bool) -> bool:
        """Return whether git ignores a file or folder. Ignored folders above it are not considered."""
        folder, name = os.path.split(path)
        for below, patterns in self._patterns_for(self._real_folder(folder)):
            for pattern in patterns:
                if pattern.matches((*below, name), is_folder=is_folder):
                    return pattern.ignores
        return False

    def _real_folder(self, folder: str) -> str:
        """A folder with all links followed. That of the folder around it is mostly known, so only one step is left."""
        if folder not in self._real:
            above, name = os.path.split(folder)
            step = os.path.join(self._real[above], name) if above in self._real and name != os.pardir else ""
            self._real[folder] = step if step and name and not os.path.islink(step) else os.path.realpath(folder)
        return self._real[folder]

    def expects(self, path: str) -> bool:
        """Return whether git ignores a file or a folder above it: such a file is made later, and is not committed."""
        if self.ignores(path, is_folder=False):
            return True
        return any(
            self.ignores(folder, is_folder=True)
            for folder in folders_upwards(os.path.dirname(path))
            if self._top and folder.startswith(self._top.rstrip(os.sep) + os.sep)
        )

    def _patterns_for(self, folder: str) -> list[_Applying]:
        """The patterns that apply in a folder, those with the highest precedence first."""
        top = self._top
        if top is None or not (folder + os.sep).startswith(top.rstrip(os.sep) + os.sep):
            return []
        unknown = []
        while folder not in self._applying:
            unknown.append(folder)
            if folder == top:
                break
            folder = os.path.dirname(folder)
        for below in reversed(unknown):
            above = self._applying[os.path.dirname(below)] if below != top else []
            shared = _patterns(os.path.join(below, ".git", "info", "exclude")) if below == top else ()
            own = (*shared, *_patterns(os.path.join(below, ".gitignore")))[::-1]
            name = os.path.basename(below)
            inherited = [((*parts, name), patterns) for parts, patterns in above]
            self._applying[below] = [((), own), *inherited] if own else inherited
            folder = below
        return self._applying[folder]


_Applying = tuple[tuple[str, ...], tuple[IgnorePattern, ...]]
"""A folder as path parts relative to a .gitignore, and the patterns of that .gitignore, last one first."""


def _repository(folder: str) -> str | None:
    return next((each for each in folders_upwards(folder) if gate.exists(os.path.join(each, ".git"))), None)


def _patterns(file: str) -> tuple[IgnorePattern, ...]:
    try:
        text = first_bytes(file, _MOST_BYTES).decode("utf-8", "surrogateescape")
    except OSError:
        return ()
    return tuple(patterns_of(text.removeprefix("\ufeff")))


def patterns_of(text: str) -> Iterator[IgnorePattern]:
    """Yield the patterns of a .gitignore."""
    for line in text.split("\n"):
        pattern = re.sub(r"(?<!\\) +\Z", "", line.removesuffix("\r"))
        if not pattern or pattern.startswith("#"):
            continue
        ignores = not pattern.startswith("!")
        pattern = pattern if ignores else pattern[1:]
        only_folders = pattern.endswith("/")
        pattern = pattern.removesuffix("/")
        anywhere = "/" not in pattern
        parts = [_glob(part) for part in pattern.removeprefix("/").split("/")]
        if parts != [""]:
            yield IgnorePattern(tuple(parts), ignores, only_folders, anywhere)


def _glob(part: str) -> str:
    """Return a part of git's pattern as fnmatch spells it: escaped characters in brackets."""
    if re.fullmatch(r"\*\*+", part):
        return "**"
    escaped = re.sub(r"\\(.)", lambda match: f"[{match[1]}]" if match[1] in "*?[" else match[1], part)
    return re.sub(r"\*\*+", "*", escaped).replace("[^", "[!")


def _matches_name(name: str, part: str) -> bool:
    return part == "**" or fnmatchcase(name, part)


def _matches_parts(path: Sequence[str], pattern: Sequence[str]) -> bool:
    """Return whether a pattern matches a path. On a mismatch, only the last `**` needs another try, as for stars."""
    at = part = 0
    star, resumed = -1, 0
    while at < len(path):
        if part < len(pattern) and pattern[part] == "**":
            if part + 1 == len(pattern):
                return True
            star, resumed = part, at
            part += 1
        elif part < len(pattern) and fnmatchcase(path[at], pattern[part]):
            at, part = at + 1, part + 1
        elif star >= 0:
            resumed += 1
            at, part = resumed, star + 1
        else:
            return False
    return part == len(pattern)
