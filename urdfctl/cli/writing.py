"""Writes to files, whole or not at all, and to standard output."""

from __future__ import annotations

import errno
import os
import stat
import sys

from urdfctl.errors import UserError


def print_text(text: str) -> None:
    """Print a text as UTF-8, whatever the locale. UserError where there is no room for it."""
    print_bytes(encoded(text))


def print_bytes(data: bytes) -> None:
    """Print bytes as they are. UserError where there is no room for them."""
    try:
        sys.stdout.flush()
        sys.stdout.buffer.write(data)
        sys.stdout.buffer.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        raise UserError(f"standard output cannot be written: {error.strerror}") from None


def tell(line: str) -> None:
    """Say a line on standard error. What a stranger's files and their names hold is shown there, not obeyed."""
    from urdfctl.report.common import visible

    sys.stderr.write(f"urdfctl: {visible(line)}\n")


def encoded(text: str) -> bytes:
    """A text as UTF-8; the bytes of file names that are none stay as they are."""
    try:
        return text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return text.encode("utf-8", "backslashreplace")


def is_in_the_way(path: str) -> bool:
    """Whether something stands at a path that writing there would destroy: anything but a device or a pipe."""
    return os.path.lexists(path) and not _is_device(path)


def write_file(path: str, text: str, *, force: bool) -> None:
    """Write a text beside its place first, then rename. UserError where a file stands there already (unless `force`) or
    it cannot be written."""
    if os.path.isdir(path):
        raise UserError(f"'{path}' is a folder")
    if is_in_the_way(path) and not force:
        raise UserError(f"'{path}' exists; --force overwrites it")
    try:
        if _is_device(path):
            with open(path, "wb", opener=_without_waiting) as file:
                file.write(encoded(text))
            return
        _write_beside(os.path.realpath(path), encoded(text))
    except OSError as error:
        raise UserError(f"'{path}' cannot be written: {error.strerror}") from None


def replace_file(path: str, before: bytes, after: bytes) -> None:
    """Write a file anew that held `before`, whole or not at all. UserError where it holds something else by now, or
    cannot be written."""
    try:
        with open(path, "rb") as file:
            found = file.read()
        if found != before:
            raise UserError(f"'{path}' was changed meanwhile, and is left as it is")
        _write_beside(path, after)
    except OSError as error:
        raise UserError(f"'{path}' cannot be written: {error.strerror}") from None


def _is_device(path: str) -> bool:
    """Whether a path is a device or a pipe, such as /dev/stdout."""
    return os.path.exists(path) and not os.path.isfile(path) and not os.path.isdir(path)


def _without_waiting(path: str, flags: int) -> int:
    """Open a device, or a pipe if somebody reads it."""
    if sys.platform == "win32":
        return os.open(path, flags)
    try:
        handle = os.open(path, flags | os.O_NONBLOCK)
    except OSError as error:
        if error.errno == errno.ENXIO and stat.S_ISFIFO(os.stat(path).st_mode):
            raise OSError(error.errno, "it is a pipe that nobody reads") from None
        raise
    os.set_blocking(handle, True)
    return handle


def _write_beside(path: str, data: bytes) -> None:
    import tempfile

    handle, temporary = tempfile.mkstemp(prefix=f".{os.path.basename(path)}.", dir=os.path.dirname(path))
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        _keep_owner(path, temporary)
        os.chmod(temporary, _mode(path))
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def _keep_owner(path: str, temporary: str) -> None:
    """Give a file the owner of the one that it will replace, where we may."""
    if sys.platform == "win32":
        return
    try:
        old, new = os.stat(path), os.stat(temporary)
        if (old.st_uid, old.st_gid) != (new.st_uid, new.st_gid):
            os.chown(temporary, old.st_uid, old.st_gid)
    except OSError:  # there is none yet, or it is not ours to give
        return


def _mode(path: str) -> int:
    """The permissions that the file has, or that a new one would get."""
    try:
        return os.stat(path).st_mode & 0o7777
    except OSError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
