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

from urdfctl.cli.cache import cache_folder
from urdfctl.cli.writing import print_message, write_beside
from urdfctl.fix.edits import Change, bytes_of


@contextmanager
def journal(changes: Sequence[Change]) -> Iterator[None]:
    """Keep a journal of some changes while they are made, where the user has a cache folder."""
    folder = _folder()
    if folder is None:
        yield
        return
    data = json.dumps([[change.file, _text(change.before), _text(change.after)] for change in changes]).encode()
    try:
        os.makedirs(folder, mode=0o700, exist_ok=True)
        handle, path = tempfile.mkstemp(suffix=".json", dir=folder)
    except OSError:
        yield
        return
    with os.fdopen(handle, "r+b", buffering=0) as file:
        try:
            _take(file)
            with suppress(OSError):  # the disk may be full
                file.write(data)
                os.fsync(handle)
            yield
        finally:
            file.truncate(0)  # nobody may undo what is finished, once it is not locked any more
    with suppress(OSError):
        os.unlink(path)


def restore_unfinished() -> None:
    """Restore the files that killed runs left half written, except those that were changed since; print which."""
    for message in _restored():
        print_message(message)


def _restored() -> Iterator[str]:
    folder = _folder()
    names = sorted(os.listdir(folder)) if folder and os.path.isdir(folder) else []
    for name in names:
        path = os.path.join(folder or "", name)
        try:
            with open(path, "r+b") as file:
                if not _take(file):
                    continue  # its run is still writing
                changes = _changes(file.read())
        except OSError:
            continue
        for change in changes:
            yield from _undone(change)
        with suppress(OSError):
            os.unlink(path)


def _changes(data: bytes) -> list[Change]:
    """The changes of a journal; none if its run was killed before it was complete, and so before any change."""
    try:
        return [Change(str(file), _bytes(before), _bytes(after)) for file, before, after in json.loads(data)]
    except (ValueError, TypeError):
        return []


def _undone(change: Change) -> Iterator[str]:
    file = change.file
    try:
        _remove_temporary(change)
        if bytes_of(file) != change.after or change.after == change.before:
            return
        if change.before is None:
            os.unlink(file)
        else:
            write_beside(file, change.before)
    except OSError as error:
        yield f"'{file}' stays as a killed run left it: {error.strerror}"
    else:
        yield f"'{file}' is as it was before a run that was killed while it wrote"


def _remove_temporary(change: Change) -> None:
    """Remove what a killed run wrote beside a file to rename it."""
    folder, name = os.path.split(change.file)
    for other in os.listdir(folder) if os.path.isdir(folder) else ():
        path = os.path.join(folder, other)
        if other.startswith(f".{name}.") and change.after is not None and bytes_of(path) == change.after:
            os.unlink(path)


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
