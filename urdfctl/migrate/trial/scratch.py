"""A copy of packages in a temporary folder, in which a migration is made and judged before anything is written."""

from __future__ import annotations

import os
import shutil
import stat
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.errors import UserError
from urdfctl.output.change import Change, bytes_of
from urdfctl.output.scratch import scratch_folder
from urdfctl.source.disk.files import folders_upwards
from urdfctl.source.disk.gate import is_file, is_folder, walk
from urdfctl.source.disk.gitignore import GitIgnore
from urdfctl.source.workspaces.package_folders import package_folders
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.workspaces.workspace import workspace_of
from urdfctl.startup.records import NamedTuple

_PRUNED = frozenset({".git", "build", "install", "log", "devel", "node_modules", "__pycache__"})
_COPIED = 1 << 20
"""Larger files are linked: only texts are edited."""


class WrittenFile(NamedTuple):
    """The content that was written to a file; None if it was deleted.

    is_new: whether the user does not have the file.
    """

    after: bytes | None
    is_new: bool


class Scratch:
    """A copy of some packages, below a folder that stands for their workspace.

    root: the copy of the workspace.
    folders: the copies of the folders to migrate.
    others: the folders of the workspace's other packages, which are not copied; without those that have the name of a
        package to migrate.
    written: the files that differ from the user's, by their paths in the copy.
    """

    def __init__(self, paths: Sequence[str]) -> None:
        real = _folders(paths)
        self._workspace = os.path.realpath(workspace_of(os.path.join(real[0], "package.xml")))
        if not all(_is_below(folder, self._workspace) for folder in real):
            self._workspace = os.path.commonpath(real)
        self._temporary = scratch_folder()
        self.root = os.path.join(os.path.realpath(self._temporary.name), os.path.basename(self._workspace) or "ws")
        self.folders = [self.of(folder) for folder in real]
        self._mark = os.path.join(os.path.realpath(self._temporary.name), ".copied")
        try:
            for folder, copy in zip(real, self.folders, strict=True):
                _copy(folder, copy)
            self._copy_settings(real)
        except BaseException:
            self.close()
            raise
        mine = {_name(folder) for copied in real for folder in package_folders(copied)}
        others = (os.path.realpath(folder) for folder in package_folders(self._workspace))
        outside = (folder for folder in others if not any(_is_below(folder, copied) for copied in real))
        self.others = [folder for folder in outside if _name(folder) not in mine]
        self.written: dict[str, WrittenFile] = {}
        self._originals: dict[str, bytes | None] = {}

    def close(self) -> None:
        """Delete the copy."""
        self._temporary.cleanup()

    def check(self) -> None:
        """Raise UserError if another program deleted the copy meanwhile, as cleaners of temporary folders do."""
        if not is_folder(self._mark):
            raise UserError(f"the copy in '{self._temporary.name}' was deleted by another program; run urdfctl again")

    def of(self, real: str) -> str:
        """Return the path in the copy that stands for a real path."""
        return os.path.normpath(os.path.join(self.root, os.path.relpath(real, self._workspace)))

    def real(self, path: str) -> str:
        """Return the real path that a path in the copy stands for; other paths unchanged."""
        return (
            os.path.normpath(os.path.join(self._workspace, os.path.relpath(path, self.root)))
            if self.has(path)
            else path
        )

    def has(self, path: str) -> bool:
        """Return whether a path is in the copy."""
        return _is_below(os.path.normpath(path), self.root)

    def shown(self, text: str) -> str:
        """Return a text with the real paths instead of those in the copy."""
        return text.replace(self.root, self._workspace)

    def may_write(self, path: str) -> bool:
        """Return whether a migration may change, create or delete a file: it is in a folder to migrate."""
        return any(_is_below(os.path.realpath(path), folder) for folder in self.folders)

    def is_hidden(self, path: str) -> bool:
        """Return whether a file is in a hidden folder below a folder to migrate."""
        around = (os.path.relpath(os.path.dirname(path), folder) for folder in self.folders if _is_below(path, folder))
        return any(part.startswith(".") and part != os.curdir for one in around for part in one.split(os.sep))

    def original(self, path: str) -> bytes:
        """Return what a file was before it was written; empty if it did not exist, or is no file of the copy: a link
        may lead out of it, or to a folder."""
        path = os.path.normpath(path)
        if path in self._originals:
            return self._originals[path] or b""
        return self.content(path)

    def content(self, path: str) -> bytes:
        """Return what a file of the copy holds now; empty if it does not exist, or a link leads out of the copy."""
        if not _is_below(os.path.realpath(path), os.path.realpath(self.root)) or not os.path.isfile(path):
            return b""
        return bytes_of(path) or b""

    def write(self, path: str, data: bytes | None) -> None:
        """Write a file in the copy, or delete it if `data` is None."""
        path = os.path.normpath(path)
        self._originals.setdefault(path, bytes_of(path))
        original = self._originals[path]
        self.written.pop(path, None)
        if data != original:
            self.written[path] = WrittenFile(data, is_new=original is None)
        if data is None:
            if os.path.lexists(path):
                os.unlink(path)
            return
        os.makedirs(os.path.dirname(path), exist_ok=True)
        if os.path.lexists(path):
            os.unlink(path)  # it may be a link to the user's file
        with open(path, "wb") as file:
            file.write(data)

    def restore(self, written: Mapping[str, WrittenFile]) -> None:
        """Return to an earlier state: a copy of what `written` was then."""
        for path in {**self.written, **written}:
            if self.written.get(path) != written.get(path):
                self.write(path, written[path].after if path in written else self._originals[path])

    def changes(self) -> tuple[Change, ...]:
        """Return what was written, with real paths; `before` is None for a new file, `after` for a deleted one."""
        found = ((path, before, bytes_of(path)) for path, before in self._originals.items())
        return tuple(sorted(Change(self.real(path), old, new) for path, old, new in found if old != new))

    def changes_between(
        self, before: Mapping[str, WrittenFile], after: Mapping[str, WrittenFile]
    ) -> tuple[Change, ...]:
        """Return what differs between two states, with real paths."""

        def content(state: Mapping[str, WrittenFile], path: str) -> bytes | None:
            return state[path].after if path in state else self._originals.get(path)

        paths = sorted(path for path in {**before, **after} if before.get(path) != after.get(path))
        found = ((self.real(path), content(before, path), content(after, path)) for path in paths)
        return tuple(Change(*one) for one in found if one[1] != one[2])

    def files(self, *, with_links: bool = False) -> Iterator[str]:
        """Yield the files in the folders to migrate, in order, except those that git ignores.

        with_links: also links to folders.
        """
        for folder in self.folders:
            git = GitIgnore(folder)
            for current, folders, names in walk(folder):
                wanted = (name for name in folders if name not in _PRUNED)
                folders[:] = sorted(
                    one for one in wanted if not git.ignores(os.path.join(current, one), is_folder=True)
                )
                linked = [one for one in folders if with_links and os.path.islink(os.path.join(current, one))]
                paths = (os.path.join(current, name) for name in sorted([*names, *linked]))
                yield from (path for path in paths if not git.ignores(path, is_folder=False))

    def _copy_settings(self, real: Sequence[str]) -> None:
        """Copy the configuration files above the folders to migrate, and the .gitignore files, and mark the copy."""
        os.makedirs(self._mark, exist_ok=True)
        above = {one for folder in real for one in folders_upwards(os.path.dirname(folder))}
        for folder in sorted(one for one in above if _is_below(one, self._workspace)):
            _mark_repository(folder, self.of(folder))
            for name in ("urdfctl.toml", "pyproject.toml", ".gitignore"):
                if is_file(os.path.join(folder, name)):
                    os.makedirs(self.of(folder), exist_ok=True)
                    shutil.copyfile(os.path.join(folder, name), os.path.join(self.of(folder), name))


def _folders(paths: Sequence[str]) -> list[str]:
    """The folders that paths mean, by real path and in order: the package around a file or folder, or the folder."""
    found = []
    for path in paths:
        if not os.path.exists(path):
            raise UserError(f"file or folder '{path}' does not exist")
        folder = path if os.path.isdir(path) else os.path.dirname(os.path.abspath(path))
        found.append(os.path.realpath(package_around(os.path.abspath(folder)) or folder))
    return sorted(folder for folder in {*found} if not any(folder != one and _is_below(folder, one) for one in found))


def _name(folder: str) -> str | None:
    return package_name(os.path.join(folder, "package.xml"))


def _is_below(path: str, folder: str) -> bool:
    return (path + os.sep).startswith(folder.rstrip(os.sep) + os.sep)


def _copy(folder: str, copy: str) -> None:
    for current, folders, names in walk(folder):
        folders[:] = [name for name in folders if name not in _PRUNED]
        target = os.path.normpath(os.path.join(copy, os.path.relpath(current, folder)))
        try:
            os.makedirs(target, exist_ok=True)
        except OSError as error:  # the path of the copy is too long, for example
            raise UserError(f"'{current}' cannot be copied: {error.strerror}") from None
        _mark_repository(current, target)
        linked = (name for name in folders if os.path.islink(os.path.join(current, name)))
        for name in (*(name for name in names if name not in _PRUNED), *linked):
            path = os.path.join(current, name)
            if os.path.islink(path):
                real = os.path.realpath(path)
                inside = _is_below(real, folder)
                os.symlink(
                    os.path.join(copy, os.path.relpath(real, folder)) if inside else real, os.path.join(target, name)
                )
            else:
                _copy_file(path, os.path.join(target, name))


def _mark_repository(folder: str, copy: str) -> None:
    """Make the copy of a repository a repository too, so that files that git ignores are known there."""
    if os.path.exists(os.path.join(folder, ".git")):
        os.makedirs(os.path.join(copy, ".git"), exist_ok=True)


def _copy_file(path: str, copy: str) -> None:
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):
            return
        if os.path.getsize(path) <= _COPIED:
            shutil.copy(path, copy)
            return
        try:
            os.link(path, copy)
        except OSError:  # on another device
            os.symlink(path, copy)
    except OSError as error:
        raise UserError(f"'{path}' cannot be copied: {error.strerror}") from None
