"""Find what the build file of a robot's package installs and does not have."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.disk.gate import is_file
from urdfctl.source.span import Place, SourceText
from urdfctl.source.workspaces.packages import Packages


def absent_sources(packages: Packages, files: Files, used: Iterable[SourceText]) -> tuple[tuple[str, Place], ...]:
    """Return the files and folders that CMakeLists.txt of a file's own package installs and that do not exist.

    used: other files of the target, whose packages are meant too: colcon builds all of them.
    """
    folders = {os.path.dirname(os.path.abspath(source.path)) for source in used}
    around = (packages.around(folder) for folder in sorted(folders))
    every = dict.fromkeys(folder for folder in (packages.own(), *around) if folder)
    return tuple(one for folder in every for one in _absent_in(packages, files, folder))


def _absent_in(packages: Packages, files: Files, folder: str) -> Iterator[tuple[str, Place]]:
    path = os.path.join(folder, "CMakeLists.txt")
    if not is_file(path):
        return
    from urdfctl.source.workspaces.install_maps import missing_sources

    try:
        source = files.glance(path)
    except FileProblem:
        return
    text = source.data.decode("latin-1")  # one character for each byte
    key = ("absent", folder, text)
    missing = packages.once(key, lambda: list(missing_sources(text, folder, os.path.basename(folder))))
    yield from ((name, Place(source, start, end=start + len(name))) for name, start in missing)
