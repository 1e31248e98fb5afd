"""Find what may start a robot beside launch files that start none."""

from __future__ import annotations

import os
from collections.abc import Sequence

from urdfctl.discover.robots import discover_files
from urdfctl.source.workspaces.packages import package_around
from urdfctl.source.workspaces.workspace import workspace_of


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
