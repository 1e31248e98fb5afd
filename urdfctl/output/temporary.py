"""Files and folders that stand beside what a run writes until it is whole, and what is done about those of killed runs.

The name of each says which process made it: `.urdfctl-MACHINE-PROCESS-START-RANDOM.tmp`. A later run that writes to the
folder removes those whose process has ended.
"""

from __future__ import annotations

import os
import re
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from zlib import crc32

from urdfctl.output.change import rights_of
from urdfctl.output.processes import is_running, start_of
from urdfctl.source.disk.folders import delete_folder

_NAME = re.compile(r"\.urdfctl-(?P<machine>[0-9a-f]{8})-(?P<process>[0-9]+)-(?P<start>[0-9]+)-\w{8}\.tmp")

END = ".tmp"
WEEK = 7 * 24 * 3600.0
"""Seconds after which no process of another machine, or of another container, writes to a file any more."""


def write_beside(path: str, data: bytes, *, lasting: bool = True, rights: int | None = None) -> None:
    """Write data to a temporary file beside a path, then rename it. Raises OSError if it cannot be written.

    lasting: whether the data is on the disk before it has its name, so that it outlives a power failure.
    rights: the permissions that it gets if there is no file; None for the usual ones.
    """
    temporary = temporary_beside(path, data, lasting=lasting, rights=rights)
    try:
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def temporary_beside(path: str, data: bytes, *, lasting: bool = True, rights: int | None = None) -> str:
    """Write data to a temporary file beside a path, with the permissions of the file there, and return its path.

    The other arguments are those of `write_beside`.
    """
    handle, temporary = tempfile.mkstemp(prefix=prefix(), suffix=END, dir=os.path.dirname(path))
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            if lasting:
                os.fsync(file.fileno())
        _keep_owner(path, temporary)
        os.chmod(temporary, _mode(path, rights))
    except BaseException:
        os.unlink(temporary)
        raise
    return temporary


@contextmanager
def new_folder(path: str) -> Iterator[str]:
    """Give a folder to fill, which becomes `path` at the end of the block, with the folders above that do not exist.

    Until then, and if the block fails, there is nothing at `path`, which must not exist before.
    Raises OSError if it cannot be made.
    """
    first = path
    while not os.path.lexists(os.path.dirname(first)):
        first = os.path.dirname(first)
    remove_leftovers(os.path.dirname(first))
    made = temporary_folder(os.path.dirname(first))
    try:
        os.chmod(made, 0o777 & ~_umask())
        inside = os.path.normpath(os.path.join(made, os.path.relpath(path, first)))
        os.makedirs(inside, exist_ok=True)
        yield inside
        os.rename(made, first)
    except BaseException:
        delete_folder(made)
        raise


def temporary_folder(folder: str) -> str:
    """Make an empty folder in another one, and return its path."""
    return tempfile.mkdtemp(prefix=prefix(), suffix=END, dir=folder)


def remove_leftovers(folder: str) -> None:
    """Remove the temporary files and folders in a folder that killed runs of this user left there."""
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in [entry for entry in entries if entry.name.startswith(".urdfctl-")]:
            _remove_if_left(entry)


def _remove_if_left(entry: os.DirEntry[str]) -> None:
    named = _NAME.fullmatch(entry.name)
    if named is None:
        return
    with suppress(OSError):
        info = entry.stat(follow_symlinks=False)
        if sys.platform != "win32" and info.st_uid != os.geteuid():
            return
        if named["machine"] != machine_name():
            is_over = time.time() - info.st_mtime > WEEK
        else:
            is_over = not is_running(int(named["process"]), int(named["start"]))
        if is_over and entry.is_dir(follow_symlinks=False):
            delete_folder(entry.path)
        elif is_over:
            os.unlink(entry.path)


def prefix() -> str:
    """Return how the names of this process's temporary files and folders begin."""
    process = os.getpid()
    return f".urdfctl-{machine_name()}-{process}-{start_of(process) or 0}-"


def is_of_this_process(path: str) -> bool:
    """Return whether this process made a temporary file or folder, and not the one that it is a fork of."""
    named = _NAME.fullmatch(os.path.basename(path))
    return named is not None and int(named["process"]) == os.getpid()


def machine_name() -> str:
    """Return a name for this machine, or this container: only here are the numbers of its processes known."""
    if sys.platform == "win32":
        named = os.environ.get("COMPUTERNAME", "")
    else:
        named = os.uname().nodename
        with suppress(OSError):
            named += f" {os.stat('/proc/self/ns/pid').st_ino}"
    return f"{crc32(named.encode('utf-8', 'surrogateescape')):08x}"


def _keep_owner(path: str, temporary: str) -> None:
    """Give a file the owner of the file that it will replace, if that is permitted."""
    if sys.platform == "win32":
        return
    try:
        old, new = os.stat(path), os.stat(temporary)
        if (old.st_uid, old.st_gid) != (new.st_uid, new.st_gid):
            os.chown(temporary, old.st_uid, old.st_gid)
    except OSError:  # there is no such file yet, or this user cannot change the owner
        return


def _mode(path: str, otherwise: int | None) -> int:
    """Return the permissions of a file, or those that a new file gets."""
    rights = rights_of(path)
    rights = otherwise if rights is None else rights
    return 0o666 & ~_umask() if rights is None else rights


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
