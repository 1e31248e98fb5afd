"""What is to be written to a file, and what it replaces."""

from __future__ import annotations

import errno
import os
import stat

from urdfctl.startup.records import NamedTuple


class Change(NamedTuple):
    """The bytes of a file before and after edits; None for a file that does not exist. `file` is its real path.

    rights: the permissions of a file that is made, also of one that is deleted and restored; None for the usual ones.
    """

    file: str
    before: bytes | None
    after: bytes | None
    rights: int | None = None


def rights_of(path: str) -> int | None:
    """Return the permissions of a file; None if it does not exist."""
    try:
        return stat.S_IMODE(os.stat(path).st_mode)
    except OSError:
        return None


def bytes_of(path: str) -> bytes | None:
    """Return the content of a file, None if it does not exist. OSError if it is not regular, or cannot be read."""
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):
            raise OSError(errno.EINVAL, "it is not a regular file", path)
        with open(path, "rb") as file:
            return file.read()
    except FileNotFoundError:
        return None
