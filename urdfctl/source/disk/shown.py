"""The disk as an editor shows it: open texts instead of files, a folder instead of the current one. And what is
remembered of the disk until it changes."""

from __future__ import annotations

import os
import sys
from _thread import get_ident
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import TypeVar

Result = TypeVar("Result")


class as_shown:  # noqa: N801 (a context manager, read as a verb)
    """Within it, this thread works in a folder as an editor shows it, not in the current one as it is on disk.

    folder: what is relative, is relative to it.
    texts: what is read instead of the files with these real paths.
    aside: is given the real paths of the files on which what is remembered depends, and which are no source of a robot,
        such as a package.xml.
    """

    def __init__(self, folder: str, texts: Mapping[str, bytes], aside: set[str] | None = None) -> None:
        self.folder, self.texts, self.aside = folder, texts, aside

    def __enter__(self) -> None:
        _SHOWN[get_ident()] = self

    def __exit__(self, *_: object) -> None:
        del _SHOWN[get_ident()]


_SHOWN: dict[int, as_shown] = {}
"""By thread."""


def current_folder() -> str:
    """Return the folder that this thread works in."""
    shown = _SHOWN.get(get_ident())
    return shown.folder if shown else os.getcwd()


def open_text(path: str) -> bytes | None:
    """Return the text that is read instead of a file; None if the file itself is."""
    shown = _SHOWN.get(get_ident()) if _SHOWN else None
    return shown.texts.get(real_path(path)) if shown and shown.texts else None


def note_aside(path: str) -> None:
    """Tell an editor that what is remembered depends on a file."""
    shown = _SHOWN.get(get_ident()) if _SHOWN else None
    if shown and shown.aside is not None:
        shown.aside.add(real_path(path))


# -- what is remembered ------------------------------------------------------------------------------------------------

_REMEMBERED: list[Callable[[], None]] = []
_MOST_REMEMBERED = 1 << 15
_STEP = 100
"""As many folders are looked up by recursion: less than Python's stack has room for."""


def remembered(function: Callable[[str], Result]) -> Callable[[str], Result]:
    """Remember what a function returns for a path until `forget_files` is called."""
    cached = lru_cache(_MOST_REMEMBERED)(function)
    _REMEMBERED.append(cached.cache_clear)
    return cached


@remembered
def real_path(path: str) -> str:
    """Return a path with all links followed. Where the folders above lead is looked up once for all that is in them."""
    above, name = os.path.split(path)
    is_plain = os.path.isabs(path) and name not in ("", os.curdir, os.pardir)
    if sys.platform == "win32" or not is_plain or os.path.islink(path):
        return os.path.realpath(path)
    parts = path.split(os.sep) if path.count(os.sep) > _STEP else ()
    for number in range(_STEP, len(parts) - 1, _STEP):
        real_path(os.sep.join(parts[:number]))
    return os.path.join(real_path(above), name)


def forget_files() -> None:
    """Look at the disk again: files were created, deleted or changed."""
    for forget in _REMEMBERED:
        forget()
