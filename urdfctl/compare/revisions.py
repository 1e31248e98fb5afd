"""Lay out the files of a git revision, without touching the repository or its work tree.

Anyone may have written the revision: its names, its links and its sizes are checked, and nothing leaves the folder.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Sequence

from urdfctl.errors import UserError
from urdfctl.names import did_you_mean
from urdfctl.run.git import Blobs, TreeEntry, blobs_of, commit_of, entries_of, names_of_revisions
from urdfctl.source.disk.files import MAX_BYTES

_NOT_READ = (
    ".stl",
    ".dae",
    ".obj",
    ".glb",
    ".gltf",
    ".ply",
    ".png",
    ".jpg",
    ".jpeg",
    ".tif",
    ".bag",
    ".mp4",
    ".gif",
    ".zip",
)
"""Files of these kinds are laid out empty: only whether they exist matters."""
_LINK, _SUBMODULE = "120000", "160000"
_MOST_TOTAL = 1 << 30
_MOST_LINK = 4096
_FORBIDDEN_ON_WINDOWS = re.compile(
    r'[<>:"\\|?*\x00-\x1f]|[. ]\Z|\A(?:con|prn|aux|nul|com\d|lpt\d)(?:\.|\Z)', re.IGNORECASE
)


def is_revision(word: str) -> bool:
    """Return whether a word is a revision with a path, such as `HEAD~1:urdf/robot.xacro` or `origin/main:`."""
    revision, colon, _ = word.partition(":")
    return bool(colon and revision) and not os.path.exists(word) and not os.path.splitdrive(word)[0]


def lay_out(repository: str, revision: str, folder: str) -> None:
    """Write the files of a revision into an empty folder. UserError if there is no such revision, or it cannot be."""
    commit = commit_of(repository, revision)
    if commit is None:
        known = names_of_revisions(repository)
        raise UserError(f"git revision '{revision}' does not exist{did_you_mean(revision, known)}")
    entries = entries_of(repository, commit)
    for entry in entries:
        if not all(map(_is_name, entry.name.split("/"))):
            raise UserError(f"git revision '{revision}' has a file with the name '{entry.name}', which is not written")
    try:
        with blobs_of(repository) as blobs:
            _write(entries, _Contents(blobs, revision), folder)
    except OSError as error:  # of two names that are one on this system, or of a file in the place of a folder
        path = error.filename2 or error.filename  # of a link, the first is where it leads
        name = os.path.relpath(path, folder)
        raise UserError(f"git revision '{revision}' cannot be laid out: {error.strerror}: '{name}'") from None


def _is_name(part: str) -> bool:
    """Whether a part of a path is the name of a file or folder below the one before it, on every system."""
    if part in ("", os.curdir, os.pardir) or part.lower() == ".git":
        return False
    return sys.platform != "win32" or not _FORBIDDEN_ON_WINDOWS.search(part)


def _is_empty(entry: TreeEntry) -> bool:
    return entry.name.lower().endswith(_NOT_READ)


class _Contents:
    """The content of the files of a revision, as far as somebody reads it."""

    def __init__(self, blobs: Blobs, revision: str) -> None:
        self._blobs, self._revision = blobs, revision
        self._total = 0

    def of(self, entry: TreeEntry) -> tuple[bytes, bool]:
        """Return the content of a file, and whether that is all of it. UserError if it is missing or too much."""
        if _is_empty(entry):
            return b"", True
        size = self._blobs.size(entry.key)
        is_whole = size is None or size <= MAX_BYTES
        data = self._blobs.content(entry.key) if size is not None and is_whole else None
        if data is None and is_whole:
            raise UserError(f"git revision '{self._revision}' cannot be read: '{entry.name}' is not in the repository")
        self._total += len(data or b"")
        if self._total > _MOST_TOTAL:
            raise UserError(f"git revision '{self._revision}' is larger than {_MOST_TOTAL >> 20} MiB")
        return data or b"", is_whole


def _write(entries: Sequence[TreeEntry], contents: _Contents, folder: str) -> None:
    """Write files and folders first, then links: nothing is written through a link."""
    links: list[tuple[str, bytes]] = []
    for entry in entries:
        path = os.path.join(folder, *entry.name.split("/"))
        if entry.mode == _SUBMODULE:
            os.makedirs(path, exist_ok=True)
            continue
        os.makedirs(os.path.dirname(path), exist_ok=True)
        data, is_whole = contents.of(entry)
        if entry.mode == _LINK and not _is_empty(entry):
            links.append((path, data))
            continue
        with open(path, "xb") as file:
            file.write(data)
            if not is_whole:
                file.truncate(MAX_BYTES + 1)  # too large for every reader, without its content
    for path, target in links:
        _write_link(path, target)
    for path, _ in links:
        if os.path.islink(path) and not (os.path.realpath(path) + os.sep).startswith(folder + os.sep):
            os.unlink(path)


def _write_link(path: str, target: bytes) -> None:
    """Write a symbolic link; where the system or the user has none, a file with its target, as git does."""
    if not 0 < len(target) <= _MOST_LINK or b"\0" in target:
        return
    try:
        os.symlink(os.fsdecode(target), path)
    except FileExistsError:
        raise
    except (OSError, NotImplementedError):
        with open(path, "xb") as file:
            file.write(target)
