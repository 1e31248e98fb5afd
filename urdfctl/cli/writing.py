"""Writes files whole or not at all."""

from __future__ import annotations

import os

from urdfctl.errors import UserError


def write_file(path: str, text: str, *, force: bool) -> None:
    """Write a text beside its place first, then rename. UserError where a file stands there already (unless `force`) or
    it cannot be written."""
    if os.path.lexists(path) and not force:
        raise UserError(f"'{path}' exists; --force overwrites it")
    if os.path.isdir(path):
        raise UserError(f"'{path}' is a folder")
    try:
        if os.path.exists(path) and not os.path.isfile(path):  # a device or a pipe, such as /dev/stdout
            with open(path, "wb") as file:
                file.write(text.encode())
            return
        _write_beside(os.path.realpath(path), text.encode())
    except OSError as error:
        raise UserError(f"'{path}' cannot be written: {error.strerror}") from None


def _write_beside(path: str, data: bytes) -> None:
    import tempfile

    handle, temporary = tempfile.mkstemp(prefix=f".{os.path.basename(path)}.", dir=os.path.dirname(path))
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, _mode(path))
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def _mode(path: str) -> int:
    """The permissions that the file has, or that a new one would get."""
    try:
        return os.stat(path).st_mode & 0o7777
    except OSError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
