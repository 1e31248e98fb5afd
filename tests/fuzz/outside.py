"""Watch what a process does outside of the folder that it may use: files that it opens, programs that it starts."""

from __future__ import annotations

import os
import sys
import sysconfig
from collections.abc import Callable, Sequence
from functools import lru_cache
from pathlib import Path
from types import FrameType

_CHECKOUT = Path(__file__).parents[2]
_READ_ONLY = tuple({
    *(os.path.realpath(path) for path in (sys.prefix, sys.base_prefix, *sysconfig.get_paths().values())),
    *(str(_CHECKOUT / name) for name in ("urdfctl", "templates", "samples", "tests")),
    *("/proc", "/sys", "/dev/null", "/dev/urandom", "/dev/tty", "/usr/share/zoneinfo", "/usr/share/locale"),
    *("/etc/localtime", "/etc/mime.types", "/etc/ld.so.cache"),
})  # fmt: skip
"""What the interpreter and its libraries read, wherever they are installed."""
_ONE, _TWO = slice(0, 1), slice(0, 2)
_CHANGES = {
    **dict.fromkeys(("os.remove", "os.rmdir", "os.mkdir", "os.chmod", "os.utime"), _ONE),
    **dict.fromkeys(("os.rename", "os.link"), _TWO),
    "os.symlink": slice(1, 2),
}
"""Audit events that change paths, and which of their arguments these are."""
_PROGRAMS = {"subprocess.Popen", "os.exec", "os.posix_spawn", "os.spawn", "os.system"}
_NETWORK = {"socket.connect", "socket.bind", "socket.sendto", "socket.getaddrinfo", "urllib.Request"}
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT


def watch(tell: Callable[[str], object], own: Sequence[str], programs: Sequence[str] = ()) -> None:
    """Tell from now on, in words, what this process and its forks do that they have no business with.

    own: the folders that may be read and written. programs: what may be started, by the base name.
    """
    folders = _Folders([os.path.realpath(folder) for folder in own])

    def heard(event: str, arguments: tuple[object, ...]) -> None:
        if event == "open" and not _deletes_a_tree():
            if (what := folders.opened(*arguments)) is not None:
                tell(what)
        elif event in _CHANGES:
            for path in arguments[_CHANGES[event]]:
                if not (_is_relative_to_a_folder(path, arguments) or folders.have(path)):
                    tell(f"{event} of {_text(path)}, which is outside")
        elif event in _PROGRAMS and os.path.basename(str(arguments[0])) not in programs:
            tell(f"starts {arguments[0]}")
        elif event in _NETWORK:
            tell(f"uses the network: {event}")

    sys.addaudithook(heard)


class _Folders:
    """The folders that a process may read and write."""

    def __init__(self, own: Sequence[str]) -> None:
        self._own = own
        self._real = lru_cache(4096)(os.path.realpath)

    def opened(self, path: object, mode: object, flags: object) -> str | None:
        """Return what is wrong with opening a file; None if nothing is."""
        writes = bool(flags & _WRITING) if isinstance(flags, int) else bool(set(str(mode)) & set("wax+"))
        also = () if writes and path != os.devnull else _READ_ONLY
        is_followed = not (isinstance(flags, int) and flags & getattr(os, "O_NOFOLLOW", 0))
        if self.have(path, also=also, is_followed=is_followed):
            return None
        return f"{'writes' if writes else 'reads'} {_text(path)}, which is outside"

    def have(self, path: object, *, also: Sequence[str] = (), is_followed: bool = False) -> bool:
        """Return whether a path is in a folder, with all links above it followed; and itself, if `is_followed`."""
        if isinstance(path, int) or path is None:
            return True
        text = os.path.abspath(_text(path))
        where = os.path.join(self._real(os.path.dirname(text)), os.path.basename(text))
        if is_followed and os.path.islink(where):
            where = os.path.realpath(where)
        return any(where == one or where.startswith(one + os.sep) for one in (*self._own, *also))


def _deletes_a_tree() -> bool:
    """Whether a tree is being deleted, whose folders are opened relative to the ones around them."""
    frame: FrameType | None = sys._getframe(2)
    return frame is not None and frame.f_code.co_name.startswith("_rmtree")


def _is_relative_to_a_folder(path: object, arguments: Sequence[object]) -> bool:
    """Whether a path is relative to an open folder, as when a tree is deleted; that folder was looked at before."""
    return isinstance(arguments[-1], int) and arguments[-1] >= 0 and not os.path.isabs(_text(path))


def _text(path: object) -> str:
    return os.fsdecode(path) if isinstance(path, bytes | os.PathLike) else str(path)
