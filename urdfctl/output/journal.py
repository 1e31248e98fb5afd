"""A journal of the files that a run writes: the next run undoes what a killed one left half written.

It is in the user's cache folder, so that nothing is beside the files of a run that ends as it should.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
from base64 import b64decode, b64encode
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from typing import BinaryIO

from urdfctl.output.cache_folder import cache_folder
from urdfctl.output.change import Change, bytes_of
from urdfctl.output.temporary import remove_leftovers, write_beside


@contextmanager
def journal(changes: Sequence[Change], missing: Sequence[str]) -> Iterator[None]:
    """Keep a journal of some changes while they are made, where the user has a cache folder.

    missing: the folders that do not exist before.
    """
    folder = _folder()
    if folder is None:
        yield
        return
    files = [[change.file, _text(change.before), _text(change.after), change.rights] for change in changes]
    data = json.dumps({"files": files, "missing": list(missing)}).encode()
    try:
        os.makedirs(folder, mode=0o700, exist_ok=True)
        handle, path = tempfile.mkstemp(suffix=".json", dir=folder)
    except OSError:
        yield
        return
    with os.fdopen(handle, "r+b", buffering=0) as file:
        try:
            if _take(file):  # if not, another run has just found the new file: it would undo what is written
                with suppress(OSError):  # the disk may be full
                    file.write(data)
                    os.fsync(handle)
            yield
        finally:
            file.truncate(0)  # nobody may undo what is finished, once it is not locked any more
    with suppress(OSError):
        os.unlink(path)


def restore_unfinished() -> list[str]:
    """Restore the files that killed runs left half written, except those that were changed since; return which."""
    return list(_restored())


def _restored() -> Iterator[str]:
    folder = _folder()
    names = sorted(os.listdir(folder)) if folder and os.path.isdir(folder) else []
    for name in names:
        path = os.path.join(folder or "", name)
        try:
            with open(path, "r+b") as file:
                if not _take(file):
                    continue  # its run is still writing
                changes, missing = _read(file.read())
        except OSError:
            continue
        for written in {os.path.dirname(change.file) for change in changes}:
            remove_leftovers(written)
        for change in changes:
            yield from _undone(change)
        remove_empty(missing)
        with suppress(OSError):
            os.unlink(path)


def remove_empty(folders: Sequence[str]) -> None:
    """Remove the folders that exist and are empty. folders: the outermost first."""
    for folder in reversed(folders):
        with suppress(OSError):
            if os.path.realpath(folder) == folder:  # no folder above has become a link
                os.rmdir(folder)


def _read(data: bytes) -> tuple[list[Change], list[str]]:
    """What a journal says; nothing if its run was killed before it was complete, and so before any change."""
    try:
        told = json.loads(data)
        changes = [Change(str(file), _bytes(old), _bytes(new), rights) for file, old, new, rights in told["files"]]
        return changes, [str(folder) for folder in told["missing"]]
    except (ValueError, TypeError, KeyError):
        return [], []


def _undone(change: Change) -> Iterator[str]:
    file = change.file
    try:
        if os.path.realpath(file) != file or bytes_of(file) != change.after or change.after == change.before:
            return
        if change.before is None:
            os.unlink(file)
        else:
            write_beside(file, change.before, rights=change.rights)
    except OSError as error:
        yield f"'{file}' stays as a killed run left it: {error.strerror}"
    else:
        yield f"'{file}' is as it was before a run that was killed while it wrote"


def _take(file: BinaryIO) -> bool:
    """Lock a journal until it is closed; return whether no running program holds it."""
    if sys.platform == "win32":
        import msvcrt

        try:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True
    import fcntl

    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def _folder() -> str | None:
    cache = cache_folder()
    return os.path.join(cache, "unfinished") if cache else None


def _text(data: bytes | None) -> str | None:
    return None if data is None else b64encode(data).decode("ascii")


def _bytes(text: str | None) -> bytes | None:
    return None if text is None else b64decode(text, validate=True)
