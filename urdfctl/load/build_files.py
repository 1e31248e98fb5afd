"""Find what the build file of a robot's package installs and does not have."""

from __future__ import annotations

import os

from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.disk.gate import is_file
from urdfctl.source.span import Place
from urdfctl.source.workspaces.packages import Packages


def absent_sources(packages: Packages, files: Files) -> tuple[tuple[str, Place], ...]:
    """Return the files and folders that CMakeLists.txt of a file's own package installs and that do not exist."""
    folder = packages.own()
    path = os.path.join(folder, "CMakeLists.txt") if folder else ""
    if not folder or not is_file(path):
        return ()
    from urdfctl.source.workspaces.install_maps import missing_sources

    try:
        source = files.glance(path)
    except FileProblem:
        return ()
    text = source.data.decode("latin-1")  # one character for each byte
    missing = packages.once(("absent", text), lambda: list(missing_sources(text, folder, os.path.basename(folder))))
    return tuple((name, Place(source, start, end=start + len(name))) for name, start in missing)
