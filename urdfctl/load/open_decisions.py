"""What a migration left to a person in files of a package that no target reads: worlds, models, package.xml."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterator

from urdfctl.source.disk.files import first_bytes, start_of
from urdfctl.source.disk.gate import walk
from urdfctl.source.span import Place, SourceText
from urdfctl.source.todo import has_todos, todos_in

_OF_XML = (".world", ".sdf", ".xml", ".urdf", ".xacro", ".srdf", ".launch")
_ENDINGS = (*_OF_XML, ".launch.py", ".yaml", ".yml", ".txt", ".in")
_MOST_BYTES = 4 << 20
_PRUNED = ("build", "install", "log", "devel", "__pycache__", "meshes")


def decisions_in(folder: str) -> list[tuple[str, Place]]:
    """Return the texts and places of the TODOs of a migration in the files of a package.

    Only files with TODOs count as read: a key in another file does not make an editor look at all of them again.
    """
    texts = (SourceText(path, _text(path, first_bytes)) for path in _files(folder) if has_todos(_text(path, start_of)))
    return [todo for source in texts for todo in todos_in(source)]


def unread(decisions: Collection[tuple[str, Place]], read: Collection[str]) -> tuple[tuple[str, Place], ...]:
    """Return those TODOs that are not in a file that was read."""
    known = {os.path.realpath(path) for path in read}
    return tuple(todo for todo in decisions if os.path.realpath(todo[1].source.path) not in known)


def _files(folder: str) -> Iterator[str]:
    for current, folders, names in walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name not in _PRUNED)
        yield from (os.path.join(current, name) for name in sorted(names) if name.endswith(_ENDINGS))


def _text(path: str, read: Callable[[str, int], bytes]) -> bytes:
    try:
        return read(path, _MOST_BYTES)
    except OSError:
        return b""
