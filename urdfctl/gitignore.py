"""What git ignores in a repository, by its .gitignore files and .git/info/exclude."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from fnmatch import fnmatchcase
from typing import NamedTuple

_MOST_BYTES = 1 << 20


class Pattern(NamedTuple):
    """One line: which paths below the file's folder it means, in parts between slashes; `**` are any folders."""

    parts: tuple[str, ...]
    ignores: bool
    only_folders: bool

    def means(self, path: Sequence[str], *, is_folder: bool) -> bool:
        """Whether a path is meant, given in parts from the file's folder on."""
        return (is_folder or not self.only_folders) and _fits(path, self.parts)


class GitIgnore:
    """Tells which files and folders git ignores below one folder. Each .gitignore is read once; none where the folder
    lies in no repository. What lies in an ignored folder is not asked for."""

    def __init__(self, folder: str) -> None:
        self._top = _repository(os.path.realpath(folder))
        self._read: dict[str, tuple[Pattern, ...]] = {}

    def ignores(self, path: str, *, is_folder: bool) -> bool:
        """Whether git ignores a file or folder, but for folders above the one that this is for."""
        if self._top is None:
            return False
        path = os.path.join(os.path.realpath(os.path.dirname(path)), os.path.basename(path))
        parts = os.path.relpath(path, self._top).split(os.sep)
        if parts[0] == os.pardir:
            return False
        for depth in reversed(range(len(parts))):
            for pattern in reversed(self._patterns(parts[:depth])):
                if pattern.means(parts[depth:], is_folder=is_folder):
                    return pattern.ignores
        return False

    def _patterns(self, folder: Sequence[str]) -> tuple[Pattern, ...]:
        """The patterns of one folder, the weightiest last."""
        path = os.path.join(self._top or "", *folder)
        if path not in self._read:
            own = _patterns(os.path.join(path, ".gitignore"))
            shared = () if folder else _patterns(os.path.join(path, ".git", "info", "exclude"))
            self._read[path] = (*shared, *own)
        return self._read[path]


def _repository(folder: str) -> str | None:
    while not os.path.exists(os.path.join(folder, ".git")):
        above = os.path.dirname(folder)
        if above == folder:
            return None
        folder = above
    return folder


def _patterns(file: str) -> tuple[Pattern, ...]:
    try:
        with open(file, "rb") as opened:
            text = opened.read(_MOST_BYTES).decode("utf-8", "surrogateescape")
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
            yield Pattern((*(["**"] if anywhere else []), *parts), ignores, only_folders)


def _glob(part: str) -> str:
    """A part of git's pattern as fnmatch writes it: what is escaped stands in brackets."""
    if re.fullmatch(r"\*\*+", part):
        return "**"
    escaped = re.sub(r"\\(.)", lambda match: f"[{match[1]}]" if match[1] in "*?[" else match[1], part)
    return re.sub(r"\*\*+", "*", escaped).replace("[^", "[!")


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
