"""Go through folders, and delete them, however deeply they are nested.

os.walk before Python 3.12 and shutil.rmtree before 3.13 call themselves for each level; a stranger's folders can have
more levels than Python's stack.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import suppress

Folder = tuple[str, list[str], list[str]]
"""The path of a folder, and the names of the folders and of the other files in it."""


def walk(folder: str) -> Iterator[Folder]:
    """Yield a folder and those below it as os.walk does, each before what is in it.

    A name that is removed from the list of folders is not gone into. Links to folders are yielded, but not followed.
    What cannot be read is skipped, such as a path that is longer than the system allows.
    """
    pending = [folder]
    while pending:
        current = pending.pop()
        folders: list[str] = []
        others: list[str] = []
        try:
            with os.scandir(current) as entries:
                for entry in entries:
                    (folders if _is_folder(entry) else others).append(entry.name)
        except OSError:
            continue
        yield current, folders, others
        paths = (os.path.join(current, name) for name in reversed(folders))
        pending += (path for path in paths if not os.path.islink(path))


def _is_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:  # a loop of links
        return False


def delete_folder(folder: str) -> None:
    """Delete a folder with all that is in it; what cannot be deleted stays."""
    known = [*walk(folder)]
    for current, folders, others in reversed(known):
        links = (name for name in folders if os.path.islink(os.path.join(current, name)))
        for name in (*others, *links):
            with suppress(OSError):
                os.unlink(os.path.join(current, name))
        with suppress(OSError):
            os.rmdir(current)
