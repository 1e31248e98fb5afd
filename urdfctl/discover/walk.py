"""The files below a folder that a run may read, and their texts."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfctl.discover.documented import is_document
from urdfctl.source.disk.gate import opened, walk
from urdfctl.source.disk.gitignore import GitIgnore
from urdfctl.source.disk.shown import open_text

DESCRIPTIONS = (".urdf", ".xacro")
LAUNCHES = (
    *(".launch", ".launch.xml", "_launch.xml", ".launch.py", "_launch.py"),
    *(".launch.yaml", ".launch.yml", "_launch.yaml", "_launch.yml"),
)
_LOOKED_AT = (*DESCRIPTIONS, *LAUNCHES, ".yaml", ".yml")
_PRUNED = frozenset({"build", "install", "log", "devel", "node_modules", "__pycache__"})
IGNORE_FILES = frozenset({"COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE"})
_MAX_BYTES = 16 << 20


def files_below(folder: str, *, ignored: list[str] | None = None) -> Iterator[str]:
    """Yield the files below a folder that a run may read, except those that git, colcon or catkin ignore.

    ignored: if given, the folders that colcon or catkin ignore are added to it, and read all the same.
    """
    git = GitIgnore(folder)
    for current, folders, files in walk(folder):
        if IGNORE_FILES & set(files):
            if ignored is None:
                folders.clear()
                continue
            ignored.append(current)
        folders[:] = sorted(
            name
            for name in folders
            if not (name.startswith(".") or name in _PRUNED or git.ignores(os.path.join(current, name), is_folder=True))
        )
        for name in files:
            is_launch = name.endswith(".py") and os.path.basename(current) == "launch"
            if name.endswith(_LOOKED_AT) or is_launch or is_document(name):
                path = os.path.join(current, name)
                if not git.ignores(path, is_folder=False):
                    yield path


def text_of(path: str) -> bytes:
    """Return the text of a file, as far as discovery needs it."""
    text = open_text(path)
    if text is not None:
        return text if len(text) <= _MAX_BYTES else b"<robot "
    try:
        with opened(path) as file:
            if os.fstat(file.fileno()).st_size > _MAX_BYTES:
                return b"<robot "  # the loader reports why it cannot be read
            return file.read(_MAX_BYTES)
    except OSError:
        return b"<robot "
