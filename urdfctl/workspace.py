"""The folder that bounds what may be read for a file."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import lru_cache

from urdfctl.source.packages import package_folders


def workspace_of(file: str, named: str | None = None) -> str:
    """`named`, else the nearest ancestor that is a repository or a colcon or catkin workspace, else the current folder
    if the file lies in it, else the file's package, else its folder. The ancestors looked at are those of the current
    folder where the file lies in it, else those of the file."""
    if named:
        return os.path.abspath(named)
    folder = os.path.dirname(os.path.abspath(file))
    current = os.getcwd()
    inside = (folder + os.sep).startswith(current.rstrip(os.sep) + os.sep)
    for ancestor in _ancestors(current if inside else folder):
        if _is_workspace(ancestor):
            return ancestor
    if inside:
        return current
    return next((a for a in _ancestors(folder) if os.path.exists(os.path.join(a, "package.xml"))), folder)


def _ancestors(folder: str) -> Iterator[str]:
    while True:
        yield folder
        above = os.path.dirname(folder)
        if above == folder:
            return
        folder = above


@lru_cache(1024)
def _is_workspace(folder: str) -> bool:
    if os.path.exists(os.path.join(folder, ".git")):
        return True
    source = os.path.join(folder, "src")
    if not os.path.isdir(source) or os.path.exists(os.path.join(folder, "package.xml")):
        return False
    return next(package_folders(source), None) is not None
