"""Write files atomically, and write to standard output."""

from __future__ import annotations

import errno
import os
import stat
import sys

from urdfctl.errors import UserError


def print_text(text: str) -> None:
    """Print a text as UTF-8, whatever the locale. UserError if standard output cannot be written."""
    print_bytes(encoded(text))


def print_bytes(data: bytes) -> None:
    """Print bytes unchanged. UserError if standard output cannot be written."""
    try:
        sys.stdout.flush()
        sys.stdout.buffer.write(data)
        sys.stdout.buffer.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        raise UserError(f"standard output cannot be written: {error.strerror}") from None


def is_coloured() -> bool:
    """Return whether to print colours: to a terminal, or if FORCE_COLOR is set; never if NO_COLOR is."""
    return not os.environ.get("NO_COLOR") and (bool(os.environ.get("FORCE_COLOR")) or sys.stdout.isatty())


def print_message(line: str) -> None:
    """Print a line to standard error after the program's name, with control characters escaped."""
    from urdfctl.report.common import visible

    sys.stderr.write(f"urdfctl: {visible(line)}\n")


def encoded(text: str) -> bytes:
    """Return a text as UTF-8. Bytes of file names that are not UTF-8 do not change."""
    try:
        return text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return text.encode("utf-8", "backslashreplace")


def would_overwrite(path: str) -> bool:
    """Return whether writing to a path would replace something: anything but a device or a pipe."""
    return os.path.lexists(path) and not _is_device(path)


def write_file(path: str, content: str | bytes, *, force: bool) -> None:
    """Write a text or bytes to a temporary file, then rename it.

    Raises UserError if the path exists (unless `force`) or cannot be written.
    """
    if os.path.isdir(path):
        raise UserError(f"'{path}' is a folder")
    if would_overwrite(path) and not force:
        raise UserError(f"'{path}' exists; --force overwrites it")
    data = content if isinstance(content, bytes) else encoded(content)
    try:
        if _is_device(path):
            with open(path, "wb", opener=_without_waiting) as file:
                file.write(data)
            return
        write_beside(os.path.realpath(path), data)
    except OSError as error:
        raise UserError(f"'{path}' cannot be written: {error.strerror}") from None


def _is_device(path: str) -> bool:
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


def write_beside(path: str, data: bytes) -> None:
    """Write data to a temporary file beside a path, then rename it. Raises OSError if it cannot be written."""
    temporary = temporary_beside(path, data)
    try:
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def temporary_beside(path: str, data: bytes) -> str:
    """Write data to a temporary file beside a path, with the rights of the file there, and return its path."""
    import tempfile

    handle, temporary = tempfile.mkstemp(prefix=f".{os.path.basename(path)}.", dir=os.path.dirname(path))
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        _keep_owner(path, temporary)
        os.chmod(temporary, _mode(path))
    except BaseException:
        os.unlink(temporary)
        raise
    return temporary


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


def _mode(path: str) -> int:
    """Return the permissions of a file, or those that a new file would get."""
    try:
        return os.stat(path).st_mode & 0o7777
    except OSError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
