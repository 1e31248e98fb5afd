"""The workspace of a file: only files in it are read."""

from __future__ import annotations

import os

from urdfctl.source.disk.files import folders_upwards
from urdfctl.source.disk.shown import current_folder, remembered
from urdfctl.source.workspaces.package_folders import package_folders
from urdfctl.source.workspaces.packages import package_around


def workspace_of(file: str, named: str | None = None) -> str:
    """Return the workspace of a file.

    It is the first of these that exists:

    - the folder `named` by the user;
    - the nearest ancestor that is a git repository or a colcon or catkin workspace;
    - if the current folder contains the file: the package around the current folder, or else that folder;
    - the package that contains the file;
    - the file's folder.

    The search for an ancestor starts in the current folder if that contains the file, otherwise in the file's folder.
    """
    if named:
        return os.path.abspath(named)
    folder = os.path.dirname(os.path.abspath(file))
    current = current_folder()
    inside = (folder + os.sep).startswith(current.rstrip(os.sep) + os.sep)
    for ancestor in folders_upwards(current if inside else folder):
        if _is_workspace(ancestor):
            return ancestor
    if inside:
        return package_around(current) or current
    return package_around(folder) or folder


def workspace_around(folder: str) -> str | None:
    """Return the innermost workspace that a folder, given with all links followed, is in; None if it is in none.

    It is the nearest git repository or colcon or catkin workspace, the current folder, with the package around it, or
    the package.
    """
    nearest = next((ancestor for ancestor in folders_upwards(folder) if _is_workspace(ancestor)), None)
    if nearest is not None:
        return nearest
    current = os.path.realpath(current_folder())
    current = package_around(current) or current
    return current if (folder + os.sep).startswith(current.rstrip(os.sep) + os.sep) else package_around(folder)


@remembered
def _is_workspace(folder: str) -> bool:
    if os.path.lexists(os.path.join(folder, ".git")):
        return True
    source = os.path.join(folder, "src")
    if not os.path.isdir(source) or os.path.islink(source) or os.path.lexists(os.path.join(folder, "package.xml")):
        return False
    return next(package_folders(source), None) is not None
