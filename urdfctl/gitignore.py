"""What git ignores in a repository, by its .gitignore files and .git/info/exclude."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from fnmatch import fnmatchcase

from urdfctl.record import NamedTuple
from urdfctl.source.files import first_bytes

_MOST_BYTES = 1 << 20


class Pattern(NamedTuple):
    """One line: which paths below the file's folder it means, in parts between slashes, of which `**` are any folders;
    or which names `anywhere`."""

    parts: tuple[str, ...]
    ignores: bool
    only_folders: bool
    anywhere: bool

    def means(self, path: Sequence[str], *, is_folder: bool) -> bool:
        """Whether a path is meant, given in parts from the file's folder on."""
        if self.only_folders and not is_folder:
            return False
        return _is_named(path[-1], self.parts[0]) if self.anywhere else _fits(path, self.parts)


class GitIgnore:
    """Tells which files and folders git ignores below one folder. Each .gitignore is read once; none where the folder
    lies in no repository. What lies in an ignored folder is not asked for."""

    def __init__(self, folder: str) -> None:
        self._top = _repository(os.path.realpath(folder))
        self._holding: dict[str, list[_Holding]] = {}
        self._read: dict[str, tuple[Pattern, ...]] = {}

    def ignores(self, path: str, *, is_folder: bool) -> bool:
        """Whether git ignores a file or folder, but for folders above the one that this is for."""
        folder, name = os.path.split(path)
        if folder not in self._holding:
            self._holding[folder] = list(self._patterns_for(os.path.realpath(folder)))
        for below, patterns in self._holding[folder]:
            for pattern in patterns:
                if pattern.means((*below, name), is_folder=is_folder):
                    return pattern.ignores
        return False

    def _patterns_for(self, folder: str) -> Iterator[_Holding]:
        """The patterns that hold in a folder, the weightiest first."""
        top = self._top
        if top is None or not (folder + os.sep).startswith(top.rstrip(os.sep) + os.sep):
            return
        below: tuple[str, ...] = ()
        while True:
            if folder not in self._read:
                shared = _patterns(os.path.join(folder, ".git", "info", "exclude")) if folder == top else ()
                self._read[folder] = (*shared, *_patterns(os.path.join(folder, ".gitignore")))[::-1]
            if self._read[folder]:
                yield below, self._read[folder]
            if folder == top:
                return
            below = (os.path.basename(folder), *below)
            folder = os.path.dirname(folder)


_Holding = tuple[tuple[str, ...], tuple[Pattern, ...]]
"""A folder, by the parts that lead from one with patterns to it, and those patterns, the last first."""


def _repository(folder: str) -> str | None:
    while not os.path.exists(os.path.join(folder, ".git")):
        above = os.path.dirname(folder)
        if above == folder:
            return None
        folder = above
    return folder


def _patterns(file: str) -> tuple[Pattern, ...]:
    try:
        text = first_bytes(file, _MOST_BYTES).decode("utf-8", "surrogateescape")
    except OSError:
        return ()
    return tuple(patterns_of(text.removeprefix("\ufeff")))


def patterns_of(text: str) -> Iterator[Pattern]:
    """The patterns of a .gitignore."""
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
            yield Pattern(tuple(parts), ignores, only_folders, anywhere)


def _glob(part: str) -> str:
    """A part of git's pattern as fnmatch writes it: what is escaped stands in brackets."""
    if re.fullmatch(r"\*\*+", part):
        return "**"
    escaped = re.sub(r"\\(.)", lambda match: f"[{match[1]}]" if match[1] in "*?[" else match[1], part)
    return re.sub(r"\*\*+", "*", escaped).replace("[^", "[!")


def _is_named(name: str, part: str) -> bool:
    return part == "**" or fnmatchcase(name, part)


def _fits(path: Sequence[str], pattern: Sequence[str]) -> bool:
    """Whether parts fit parts. As with the stars of one name, it is enough to come back to the last `**`."""
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
