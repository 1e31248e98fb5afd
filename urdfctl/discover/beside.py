"""Find what may start a robot beside launch files that start none, and what may control one that has no controllers."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Sequence

from urdfctl.discover.robots import discover_files
from urdfctl.discover.walk import text_of
from urdfctl.source.workspaces.packages import package_around
from urdfctl.source.workspaces.workspace import workspace_of


def controllers_beside(path: str, joints: Iterable[str]) -> list[str]:
    """Return the controller files in the workspace of a robot that name some of its joints, those that name most first.

    path: the file of the robot, or of what starts it.
    """
    names = [rf"(?<![\w/]){re.escape(joint)}(?![\w/])".encode() for joint in joints]
    found: dict[str, int] = {}
    for file in discover_files([workspace_of(path)]).controllers_candidates if names else ():
        text = text_of(file)
        found[file] = sum(re.search(name, text) is not None for name in names)
    return sorted((file for file, count in found.items() if count), key=lambda file: (-found[file], file))


def starts_beside(launches: Sequence[str]) -> list[str]:
    """Return the other launch files of the packages of some that may start a robot, those in the same folder first.

    If there are none, the descriptions in the packages are returned, or else those in the workspaces.
    """
    if not launches:
        return []
    folders = {os.path.dirname(os.path.abspath(path)) for path in launches}
    packages = dict.fromkeys(package_around(folder) or folder for folder in sorted(folders))
    files = discover_files([*packages])
    named = {os.path.abspath(path) for path in launches}
    others = [path for path in files.launch_candidates if os.path.abspath(path) not in named]
    nearest = sorted(others, key=lambda path: (os.path.dirname(os.path.abspath(path)) not in folders, path))
    return nearest or files.candidates or discover_files(sorted({workspace_of(path) for path in named})).candidates
