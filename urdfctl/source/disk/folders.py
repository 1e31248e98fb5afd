"""Go through folders, and delete them, however deeply they are nested.

os.walk before Python 3.12 and shutil.rmtree before 3.13 call themselves for each level; a stranger's folders can have
more levels than Python's stack.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import suppress

Folder = tuple[str, list[str], list[str]]
"""The path of a folder, and the names of the folders and of the other files in it."""


def walk(folder: str, admits: Callable[[str], bool] | None = None) -> Iterator[Folder]:
    """Yield a folder and those below it as os.walk does, each before what is in it.

    A name that is removed from the list of folders is not gone into. Links to folders are yielded, but not followed.
    What cannot be read is skipped, such as a path that is longer than the system allows.

    admits: returns whether what a link leads to may be looked at. One that may not counts as a file.
    """
    pending = [folder]
    while pending:
        current = pending.pop()
        folders: list[str] = []
        others: list[str] = []
        links: set[str] = set()
        try:
            with os.scandir(current) as entries:
                for entry in entries:
                    is_link = entry.is_symlink()
                    if is_link:
                        links.add(entry.name)
                    is_looked_at = not is_link or admits is None or admits(entry.path)
                    (folders if is_looked_at and _is_folder(entry) else others).append(entry.name)
        except OSError:
            continue
        yield current, folders, others
        pending += (os.path.join(current, name) for name in reversed(folders) if name not in links)


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
