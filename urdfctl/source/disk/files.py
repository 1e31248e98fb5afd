"""Read files within limits: only regular files, of at most 16 MiB, and only below the folders that the run may read."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType

from urdfctl.errors import UserError
from urdfctl.source.disk import gate
from urdfctl.source.disk.shown import note_aside, open_text
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText

MAX_BYTES = 16 << 20
_NONE: Mapping[str, bytes] = MappingProxyType({})
_LAUNCHES = (
    ".launch",
    ".launch.xml",
    "_launch.xml",
    ".launch.yaml",
    ".launch.yml",
    "_launch.yaml",
    "_launch.yml",
    ".py",
)
_YAML = (".yaml", ".yml")


def is_launch(path: str) -> bool:
    """Return whether a file is a launch file by its name. Every Python file counts as one."""
    return path.endswith(_LAUNCHES)


def is_yaml(path: str) -> bool:
    """Return whether a file is a YAML file, but not a launch file, by its name."""
    return path.endswith(_YAML) and not is_launch(path)


class FileProblem(Exception):
    """A file cannot be read.

    The caller knows which place in the source refers to the file, and makes the problem with `at`.
    """

    def __init__(self, kind: ProblemKind, path: str, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.kind, self.path, self.message, self.hint = kind, path, message, hint

    def at(self, place: Place) -> Problem:
        """Return the problem, reported at a place."""
        return Problem(self.kind, place, self.message, self.path, self.hint)


class Files:
    """Reads files, each once, also among the copies that `again` and `copy` make.

    bounds: the folders below which files can be read; None for no bounds.
    resolve: maps an installed path to the source file that is installed there.
    held: contents that replace those on disk, by real path (all links followed).
    """

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
        self._texts: dict[str, SourceText] = {}
        self._within: dict[str, bool] = {}

    def again(self, resolve: Callable[[str], str]) -> Files:
        """Return files with the same bounds, and no sources yet. A text that one of both has read is not read again."""
        other = Files(None, resolve, self._held)
        other.bounds = self.bounds and list(self.bounds)
        other._texts, other._within = self._texts, self._within
        return other

    def copy(self) -> Files:
        """Return files with the same bounds and sources. What one of both reads then is no source of the other."""
        other = self.again(self._resolve)
        other._read = dict(self._read)
        return other

    def holding(self, held: Mapping[str, bytes]) -> Files:
        """Return files with the same bounds and sources, which read other contents instead of those on disk."""
        other = Files(None, self._resolve, held)
        other.bounds = self.bounds and list(self.bounds)
        other._read = dict(self._read)
        return other

    def allow(self, folder: str) -> None:
        """Allow reading files below another folder."""
        if self.bounds is not None:
            real = os.path.realpath(folder)
            if not self._is_within(real):
                self.bounds.append(real)
                self._within = {}

    def sources(self) -> list[SourceText]:
        """Return the files read so far, in order."""
        return list(self._read.values())

    def read(self, path: str) -> SourceText:
        """Return the content of a file.

        Raises FileProblem if the file is missing, not a regular file, too large or out of bounds.
        """
        if path not in self._read:
            self._read[path] = self._content(path)
        return self._read[path]

    def glance(self, path: str) -> SourceText:
        """Return the content of a file without adding it to `sources`. Raises FileProblem as `read` does."""
        note_aside(path)
        return self._content(path)

    def _content(self, path: str) -> SourceText:
        resolved = self._resolve(path)
        self._check_bounds(resolved)
        if resolved not in self._texts:
            held = self._held.get(os.path.realpath(resolved)) if self._held else None
            if held is not None:
                _check_size(resolved, len(held))
            self._texts[resolved] = SourceText(_shown(resolved), _bytes_of(resolved) if held is None else held)
        return self._texts[resolved]

    def exchange(self, source: SourceText, other: SourceText) -> None:
        """Read another text instead of one of the sources from now on."""
        self._read.update({path: other for path, known in self._read.items() if known is source})

    def may_read(self, path: str) -> bool:
        """Return whether a path, with all links followed, is within the bounds."""
        if not gate.admits(path):
            return False
        if self.bounds is None:
            return True
        if path not in self._within:
            self._within[path] = self._is_within(gate.real_of(path))
        return self._within[path]

    def _is_within(self, real: str) -> bool:
        """Whether a path without links is a bound or below one."""
        bounds = self.bounds or ()
        return any(real == bound or real.startswith(bound.rstrip(os.sep) + os.sep) for bound in bounds)

    def _check_bounds(self, path: str) -> None:
        if not self.may_read(path):
            where = f" '{self.bounds[0]}'" if self.bounds else ""
            message = f"'{path}' is outside the workspace{where} and is not read"
            hint = "use a wider --workspace, add --package-path, or use --trust"
            raise FileProblem(ProblemKind.OUTSIDE_WORKSPACE, path, message, hint)


def _shown(path: str) -> str:
    return os.path.normpath(path)


def _check_size(path: str, size: int) -> None:
    if size > MAX_BYTES:
        message = f"'{path}' has {size >> 20} MiB; the limit is {MAX_BYTES >> 20} MiB"
        raise FileProblem(ProblemKind.BUDGET, path, message)


def _bytes_of(path: str) -> bytes:
    try:
        info = os.stat(path)
        if stat.S_ISDIR(info.st_mode):
            raise FileProblem(ProblemKind.FILE_UNREADABLE, path, f"'{path}' is a folder, not a file")
        if not stat.S_ISREG(info.st_mode):
            raise FileProblem(ProblemKind.FILE_UNREADABLE, path, f"'{path}' is not a regular file")
        _check_size(path, info.st_size)
        with gate.opened(path) as file:
            data = file.read(MAX_BYTES + 1)
        _check_size(path, len(data))
    except FileNotFoundError:
        broken = os.path.islink(path)
        message = f"'{path}' is a broken symbolic link" if broken else f"file does not exist: '{path}'"
        raise FileProblem(ProblemKind.FILE_NOT_FOUND, path, message) from None
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or str(error)
        raise FileProblem(ProblemKind.FILE_UNREADABLE, path, f"'{path}' cannot be read: {why}") from None
    return data


def folders_upwards(folder: str) -> Iterator[str]:
    """Yield a folder and all folders above it, nearest first."""
    while True:
        yield folder
        above = os.path.dirname(folder)
        if above == folder:
            return
        folder = above


def first_bytes(path: str, most: int) -> bytes:
    """Return at most `most` bytes from the start of a regular file.

    Raises OSError if the file cannot be read, is outside of what the run may read, or is not a regular file: a read
    from a pipe or a device may never end.
    """
    note_aside(path)
    return start_of(path, most)


def start_of(path: str, most: int) -> bytes:
    """Return what `first_bytes` does, of a file that is read again each time."""
    text = open_text(path)
    if text is not None:
        return text[:most]
    with gate.opened(path) as file:
        return file.read(most)


def named_bytes(path: str) -> bytes:
    """Return the content of a file that the user names, other than a robot's. Raises UserError if it cannot be read."""
    try:
        data = first_bytes(path, MAX_BYTES + 1)
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    if len(data) > MAX_BYTES:
        raise UserError(f"'{path}' cannot be read: it is larger than {MAX_BYTES >> 20} MiB")
    return data
