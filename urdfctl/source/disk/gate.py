"""The gate to the disk: what a run may read, and how a file is opened.

What a run may read follows from what its user names, never from what a file contains: the workspaces of the paths on
the command line, the files and folders that options name, and the prefixes in the environment. Whatever opens, lists or
looks for a file whose path comes from a file of the project asks this gate. Links are followed before it decides.

A process runs one command, so what it may read belongs to the process, as its current folder does; forks inherit it. A
worker narrows it for its thread to what one robot may read. Code that runs without a command may read everything.
"""

from __future__ import annotations

import errno
import os
import stat
from _thread import get_ident
from collections.abc import Iterable, Iterator
from fnmatch import filter as matching_names
from typing import BinaryIO

from urdfctl.source.disk.folders import Folder
from urdfctl.source.disk.folders import walk as all_folders
from urdfctl.source.disk.shown import real_path

_MAGIC = frozenset("*?[")
_FLAGS = os.O_RDONLY
for _name in ("O_BINARY", "O_CLOEXEC", "O_NOFOLLOW", "O_NONBLOCK"):  # not every system has each
    _FLAGS |= getattr(os, _name, 0)


class Outside(PermissionError):
    """A path leads out of what the run may read."""

    def __init__(self, path: str) -> None:
        super().__init__(errno.EACCES, "it is outside the workspace", path)


class _Reach:
    """Folders and files that may be read: those within these and within the ones of `outer`."""

    def __init__(self, roots: Iterable[str], outer: _Reach | None) -> None:
        self._roots: tuple[str, ...] = ()
        self._outer = outer
        for root in roots:
            self.add(root)

    def add(self, root: str) -> None:
        """Let a folder or file be read too."""
        self._roots += (real_path(root).rstrip(os.sep) + os.sep,)

    def holds(self, real: str) -> bool:
        """Return whether a path without links may be read."""
        return (real + os.sep).startswith(self._roots) and (self._outer is None or self._outer.holds(real))


_REACHES: dict[int | None, _Reach] = {}
"""By thread; None for threads that have none of their own."""


class reading_within:  # noqa: N801 (a context manager, read as a verb)
    """Within it, this thread may read nothing outside of some folders and files, nor outside of those around it.

    roots: the folders and files; None for no limit.
    in_all_threads: whether the limit is for threads that have none of their own.
    """

    def __init__(self, roots: Iterable[str] | None, *, in_all_threads: bool = False) -> None:
        self._key = None if in_all_threads else get_ident()
        self._before = _REACHES.get(self._key)
        self._reach = None if roots is None else _Reach(roots, self._before or _REACHES.get(None))

    def __enter__(self) -> None:
        if self._reach is not None:
            _REACHES[self._key] = self._reach

    def __exit__(self, *_: object) -> None:
        if self._before is not None:
            _REACHES[self._key] = self._before
        elif self._reach is not None:
            del _REACHES[self._key]


def admit(root: str) -> None:
    """Let the run read a folder or file besides: a temporary folder of its own, or what the user's own files name."""
    reach = _reach()
    if reach is not None:
        reach.add(root)


def is_limited() -> bool:
    """Return whether there is anything that this thread may not read."""
    return _reach() is not None


def _reach() -> _Reach | None:
    return (_REACHES.get(get_ident()) or _REACHES.get(None)) if _REACHES else None


def admits(path: str) -> bool:
    """Return whether a path, with all links followed, may be read. It may be missing."""
    reach = _reach()
    if reach is None:
        return True
    return "\0" not in path and reach.holds(real_of(path))


def real_of(path: str) -> str:
    """Return a path with all links followed; where the links of its folder lead is remembered.

    Saves: 20 µs for each of some fifty files of a robot.
    """
    if not os.path.isabs(path):
        path = os.path.join(os.getcwd(), path)
    folder, name = os.path.split(path)
    if name in ("", os.curdir, os.pardir) or os.path.islink(path):
        return os.path.realpath(path)
    return os.path.join(real_path(folder), name)


def is_file(path: str) -> bool:
    """Return whether a path is a regular file that may be read."""
    return admits(path) and os.path.isfile(path)


def is_folder(path: str) -> bool:
    """Return whether a path is a folder that may be read."""
    return admits(path) and os.path.isdir(path)


def exists(path: str) -> bool:
    """Return whether a path exists and may be read."""
    return admits(path) and os.path.exists(path)


def names_in(folder: str) -> list[str]:
    """Return the names in a folder, sorted. Raises OSError if it is no folder or may not be read."""
    _check(folder)
    return sorted(os.listdir(folder or os.curdir))


def entries_in(folder: str) -> list[os.DirEntry[str]]:
    """Return the entries of a folder; none if it cannot be listed or may not be read."""
    try:
        _check(folder)
        with os.scandir(folder) as found:
            return list(found)
    except OSError:
        return []


def walk(folder: str) -> Iterator[Folder]:
    """Yield what `folders.walk` yields for a folder; nothing if it may not be read.

    A link that leads out counts as a file, whatever it leads to.
    """
    yield from all_folders(folder, admits) if admits(folder) else ()


def matching(pattern: str) -> list[str]:
    """Return the paths that match a pattern of `glob.glob`, sorted. Only folders that may be read are listed."""
    folder, name = os.path.split(pattern)
    if _MAGIC.isdisjoint(pattern):
        return [pattern] if admits(pattern) and os.path.lexists(pattern) else []
    folders = matching(folder) if folder != pattern and not _MAGIC.isdisjoint(folder) else [folder]
    if _MAGIC.isdisjoint(name):
        return [path for each in folders for path in matching(os.path.join(each, name))]
    return [os.path.join(each, found) for each in folders for found in _matching_in(each, name)]


def _matching_in(folder: str, pattern: str) -> list[str]:
    try:
        names = names_in(folder)
    except OSError:
        return []
    shown = names if pattern.startswith(".") else [name for name in names if not name.startswith(".")]
    return matching_names(shown, pattern)


def size_of(path: str) -> int:
    """Return the size of a file in bytes. Raises OSError if it is missing or may not be read."""
    _check(path)
    return os.stat(path).st_size


def opened(path: str) -> BinaryIO:
    """Return a regular file, open for reading. Raises OSError if it is none, cannot be opened, or may not be read.

    What is opened is the path that was checked, after its links. A link or a pipe that takes its place meanwhile is
    neither followed nor waited for.
    """
    if "\0" in path:
        raise OSError(errno.EINVAL, os.strerror(errno.EINVAL), path)
    real, reach = real_of(path), _reach()
    if reach is not None and not reach.holds(real):
        raise Outside(path)
    check_regular(os.lstat(real), path)
    handle = os.open(real, _FLAGS)
    try:
        check_regular(os.fstat(handle), path)
        return os.fdopen(handle, "rb")
    except OSError:
        os.close(handle)
        raise


def _check(path: str) -> None:
    if not admits(path):
        raise Outside(path)


def check_regular(info: os.stat_result, path: str) -> None:
    """Raise OSError if what is known of a path says that it is no regular file."""
    if not stat.S_ISREG(info.st_mode):
        raise OSError(errno.EINVAL, "it is not a regular file", path)
