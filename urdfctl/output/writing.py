"""Write files atomically."""

from __future__ import annotations

import errno
import os
import stat
import sys

from urdfctl.errors import UserError


def encoded(text: str) -> bytes:
    """Return a text as UTF-8. Bytes of file names that are not UTF-8 do not change."""
    try:
        return text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return text.encode("utf-8", "backslashreplace")


def would_overwrite(path: str) -> bool:
    """Return whether writing to a path would replace something: anything but a device or a pipe."""
    return os.path.lexists(path) and not is_device(path)


def write_file(path: str, content: str | bytes, *, force: bool) -> None:
    """Write a text or bytes to a temporary file, then rename it.

    Raises UserError if the path exists (unless `force`), leads out of its workspace or cannot be written.
    """
    from urdfctl.output.links import destination

    real = destination(path)
    if os.path.isdir(path):
        raise UserError(f"'{path}' is a folder")
    if would_overwrite(path) and not force:
        raise UserError(f"'{path}' exists; --force overwrites it")
    data = content if isinstance(content, bytes) else encoded(content)
    try:
        if is_device(path):
            with open(path, "wb", opener=_without_waiting) as file:
                file.write(data)
            return
        from urdfctl.output.temporary import remove_leftovers, write_beside

        remove_leftovers(os.path.dirname(real))
        write_beside(real, data)
    except OSError as error:
        raise UserError(f"'{path}' cannot be written: {error.strerror}") from None


def is_device(path: str) -> bool:
    """Return whether a path is a device or a pipe, such as /dev/stdout."""
    return os.path.exists(path) and not os.path.isfile(path) and not os.path.isdir(path)


def _without_waiting(path: str, flags: int) -> int:
    """Open a device, or a pipe if a program reads it, without waiting."""
    if sys.platform == "win32":
        return os.open(path, flags)
    try:
        handle = os.open(path, flags | os.O_NONBLOCK)
    except OSError as error:
        if error.errno == errno.ENXIO and stat.S_ISFIFO(os.stat(path).st_mode):
            raise OSError(error.errno, "it is a pipe that no program reads") from None
        raise
    os.set_blocking(handle, True)
    return handle
