"""Find what is wrong in the build file of a robot's package: what it installs and does not have, and forgets."""

from __future__ import annotations

import os
from collections.abc import Iterable

from urdfctl.model.project import BuildFaults
from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.disk.gate import is_file
from urdfctl.source.span import Place, SourceText
from urdfctl.source.workspaces.packages import Packages, package_name


def build_faults(packages: Packages, files: Files, used: Iterable[SourceText]) -> BuildFaults:
    """Return what is wrong in CMakeLists.txt of a file's own package.

    used: other files of the target, whose packages are meant too: colcon builds all of them.
    """
    folders = {os.path.dirname(os.path.abspath(source.path)) for source in used}
    around = (packages.around(folder) for folder in sorted(folders))
    every = dict.fromkeys(folder for folder in (packages.own(), *around) if folder)
    found = [faults for folder in every if (faults := _faults_in(packages, files, folder)) is not None]
    return BuildFaults(
        absent=tuple(one for faults in found for one in faults.absent),
        unregistered=tuple(one for faults in found for one in faults.unregistered),
    )


def _faults_in(packages: Packages, files: Files, folder: str) -> BuildFaults | None:
    path = os.path.join(folder, "CMakeLists.txt")
    if not is_file(path):
        return None
    from urdfctl.source.workspaces.install_maps import missing_sources, unregistered_project

    try:
        source = files.glance(path)
    except FileProblem:
        return None
    text = source.data.decode("latin-1")  # one character for each byte
    key = ("faults of the build file", folder, text)
    missing, project = packages.once(
        key, lambda: (list(missing_sources(text, folder, os.path.basename(folder))), unregistered_project(text))
    )
    package = (package_name(os.path.join(folder, "package.xml")) or os.path.basename(folder)) if project else ""
    return BuildFaults(
        absent=tuple((name, Place(source, start, end=start + len(name))) for name, start in missing),
        unregistered=((package, Place(source, project[0], end=project[1])),) if project else (),
    )
