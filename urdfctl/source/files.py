"""Reads files, within limits: regular files only, not larger than 16 MiB, and only where the run may read."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

from urdfctl.errors import UserError
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText

MAX_BYTES = 16 << 20
_NONE: Mapping[str, bytes] = MappingProxyType({})
_LAUNCHES = (".launch", ".launch.xml", "_launch.xml", ".launch.yaml", ".launch.yml", "_launch.yaml", ".py")
_YAML = (".yaml", ".yml")


def is_launch(path: str) -> bool:
    """Whether a file is a launch file by its name; Python can be nothing else here."""
    return path.endswith(_LAUNCHES)


def is_yaml(path: str) -> bool:
    """Whether a file is a parameter file by its name."""
    return path.endswith(_YAML) and not is_launch(path)


class FileProblem(Exception):
    """A file cannot be read; whoever asked for it knows the place to blame."""

    def __init__(self, kind: ProblemKind, path: str, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.kind, self.path, self.message, self.hint = kind, path, message, hint

    def at(self, place: Place) -> Problem:
        """The problem, blamed on a place."""
        return Problem(self.kind, place, self.message, self.path, self.hint)


class Files:
    """Reads each file once. `resolve` maps an installed path to the source file that would be installed there; `held`
    are files, by their paths with all links followed, that are to be read as if they held other bytes."""

    def __init__(
        self,
        bounds: Sequence[str] | None = None,
        resolve: Callable[[str], str] = lambda path: path,
        held: Mapping[str, bytes] = _NONE,
    ) -> None:
        self.bounds = None if bounds is None else [os.path.realpath(bound) for bound in bounds]
        self._resolve = resolve
        self._held = held
        self._read: dict[str, SourceText] = {}

    def allow(self, folder: str) -> None:
        """Let files below a folder be read too."""
        if self.bounds is not None:
            real = os.path.realpath(folder)
            if real not in self.bounds:
                self.bounds.append(real)

    def sources(self) -> list[SourceText]:
        """The texts that have been read, in order."""
        return list(self._read.values())

    def read(self, path: str) -> SourceText:
        """The text of a file. FileProblem where there is none, it is no regular file, too large or out of bounds."""
        if path not in self._read:
            self._read[path] = self.glance(path)
        return self._read[path]

    def glance(self, path: str) -> SourceText:
        """The text of a file that is looked into, and is none of those that count as read. FileProblem as above."""
        found = self._resolve(path)
        self._check_bounds(found)
        held = self._held.get(os.path.realpath(found)) if self._held else None
        return SourceText(_shown(found), _bytes_of(found) if held is None else held)

    def may_read(self, path: str) -> bool:
        """Whether a path, with its links followed, lies where the run may read."""
        if self.bounds is None:
            return True
        real = os.path.realpath(path)
        return any(real == bound or real.startswith(bound.rstrip(os.sep) + os.sep) for bound in self.bounds)

    def _check_bounds(self, path: str) -> None:
        if self.bounds is not None and not self.may_read(path):
            message = f"'{path}' lies outside the workspace '{self.bounds[0]}' and is not read"
            hint = "name a wider --workspace, add --package-path, or --trust the file"
            raise FileProblem(ProblemKind.OUTSIDE_WORKSPACE, path, message, hint)


def _shown(path: str) -> str:
    return os.path.normpath(path)


def _bytes_of(path: str) -> bytes:
    try:
        info = os.stat(path)
        if stat.S_ISDIR(info.st_mode):
            raise FileProblem(ProblemKind.FILE_UNREADABLE, path, f"'{path}' is a folder, not a file")
        if not stat.S_ISREG(info.st_mode):
            raise FileProblem(ProblemKind.FILE_UNREADABLE, path, f"'{path}' is no regular file")
        if info.st_size > MAX_BYTES:
            message = f"'{path}' has {info.st_size >> 20} MiB; at most {MAX_BYTES >> 20} MiB are read"
            raise FileProblem(ProblemKind.BUDGET, path, message)
        with open(path, "rb") as file:
            data = file.read(MAX_BYTES + 1)
    except FileNotFoundError:
        broken = os.path.islink(path)
        message = f"'{path}' is a broken link" if broken else f"no such file: '{path}'"
        raise FileProblem(ProblemKind.FILE_NOT_FOUND, path, message) from None
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or str(error)
        raise FileProblem(ProblemKind.FILE_UNREADABLE, path, f"'{path}' cannot be read: {why}") from None
    return data


def first_bytes(path: str, most: int) -> bytes:
    """What a regular file begins with. OSError where there is none: a pipe is not waited for, a device has no end."""
    if not stat.S_ISREG(os.stat(path).st_mode):
        raise OSError(errno.EINVAL, "it is no regular file", path)
    with open(path, "rb") as file:
        return file.read(most)


def named_bytes(path: str) -> bytes:
    """The bytes of a file that the user names for something else than a robot. UserError where it cannot be read."""
    try:
        data = first_bytes(path, MAX_BYTES + 1)
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    if len(data) > MAX_BYTES:
        raise UserError(f"'{path}' cannot be read: it is larger than {MAX_BYTES >> 20} MiB")
    return data
