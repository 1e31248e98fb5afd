"""Find the launch files of a package and its neighbours that may start what a file or folder is part of."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

from urdfctl.discover.launch_files import is_launch_file, launch_roots, may_launch
from urdfctl.discover.walk import files_below, text_of
from urdfctl.source.disk.gate import is_folder, names_in
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.workspaces.workspace import workspace_of

_MAX_NEIGHBOURS = 60
_MAX_LAUNCH_FILES = 200
_MAX_BRINGUPS = 30


def launch_files_around(paths: Sequence[str]) -> list[str]:
    """Return the launch files that may start what the paths are part of: files, or folders inside a package.

    Those of the own package and of the packages beside it are read as text; a launch file is returned if it, or one
    that it includes, names the package or one of the files. Whether it really starts them shows when it is loaded.
    """
    names: dict[tuple[str, bool], dict[bytes, None]] = {}
    for path in map(os.path.abspath, paths):
        package = _package_around(path)
        folder = package or (path if os.path.isdir(path) else os.path.dirname(path))
        names.setdefault((folder, package is not None), {}).update(dict.fromkeys(_names(path, package)))
    found: dict[str, None] = {}
    known: dict[str, dict[str, bytes]] = {}
    neighbours = _Neighbours()
    for (folder, is_package), naming in names.items():
        places = [folder, *(neighbours.launch_folders(folder) if is_package else ())]
        for place in places:
            if place not in known:
                known[place] = dict(_launch_files(place))
        launches = (launch for place in places for launch in known[place].items())
        texts = dict(islice(launches, _MAX_LAUNCH_FILES))
        found.update(dict.fromkeys(launch_roots(texts, naming=list(naming))))
        if len(found) >= _MAX_BRINGUPS:
            break
    return list(found)[:_MAX_BRINGUPS]


def _package_around(path: str) -> str | None:
    """The folder of the package that contains a path, within its workspace."""
    package = package_around(path if os.path.isdir(path) else os.path.dirname(path))
    return package if package and _is_inside(package, workspace_of(path)) else None


def _is_inside(folder: str, other: str) -> bool:
    return (folder + os.sep).startswith(other.rstrip(os.sep) + os.sep)


def is_inside_package(folder: str) -> bool:
    """Return whether a folder is below the folder of a package."""
    package = _package_around(os.path.abspath(folder))
    return package is not None and package != os.path.abspath(folder)


def _launch_files(place: str) -> Iterator[tuple[str, bytes]]:
    """Yield the launch files below a folder, with their texts."""
    paths = (os.path.relpath(path) for path in sorted(files_below(place)) if may_launch(path))
    for path in islice(paths, _MAX_LAUNCH_FILES):
        text = text_of(path)
        if is_launch_file(path, text):
            yield path, text


class _Neighbours:
    """Finds the folders `launch` of packages.

    Saves: 0.2 s for three hundred robots of seventy repositories in one folder, whose folders are listed once.
    """

    def __init__(self) -> None:
        self._beside: dict[str, list[str]] = {}
        self._in_children: dict[str, list[str]] = {}

    def launch_folders(self, package: str) -> list[str]:
        """Return the folders `launch` of the packages beside a package."""
        workspace = workspace_of(package)
        above = os.path.dirname(package)
        if not _is_inside(above, workspace):
            return []
        if above not in self._beside:
            there = dict.fromkeys(islice(self._below(above, workspace), 2 * _MAX_NEIGHBOURS + 2))
            self._beside[above] = list(there)[: _MAX_NEIGHBOURS + 1]
        own = os.path.join(package, "launch")
        return [folder for folder in self._beside[above] if folder != own][:_MAX_NEIGHBOURS]

    def _below(self, above: str, workspace: str) -> Iterator[str]:
        """Yield the folders `launch` of the packages in a folder, beside it, and in the folders beside it; those in
        the folder itself may come twice."""
        yield from self._of_children(above)
        if above != workspace:
            outer = os.path.dirname(above)
            yield from self._of_children(outer)
            for name in _listed(outer):
                yield from self._of_children(os.path.join(outer, name))

    def _of_children(self, folder: str) -> list[str]:
        """The folders `launch` of the folders in a folder."""
        if folder not in self._in_children:
            folders = (os.path.join(folder, name, "launch") for name in _listed(folder))
            self._in_children[folder] = [each for each in folders if is_folder(each)]
        return self._in_children[folder]


def _listed(folder: str) -> list[str]:
    try:
        return [name for name in names_in(folder) if not name.startswith(".")]
    except OSError:
        return []


def _names(path: str, package: str | None) -> list[bytes]:
    """What a launch file that starts a path may name: the files, and the package."""
    names: Iterable[str] = [os.path.basename(path)]
    if os.path.isdir(path):
        names = (os.path.basename(file) for file in files_below(path))
    own = package_name(os.path.join(package, "package.xml")) if package else None
    return [os.fsencode(name) for name in {*names, *([own] if own else [])}]
