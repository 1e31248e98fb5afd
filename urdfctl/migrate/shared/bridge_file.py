"""The file for ros_gz_bridge, which is found by launch files that start the bridge."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.install_rules import BRIDGE_FILE
from urdfctl.source.workspaces.packages import package_around, package_name

_FORM = b"ros_topic_name"
_LAUNCHES = (".py", ".launch", ".xml")


def bridge_file_of(packages: MigratedPackages, launch: str) -> str | None:
    """Return the package with the file for the bridge of the robots that a launch file starts; None if none is known.

    That is its own package, the only one that it or the launch files of the packages that it names do, the only one of
    the launch files that include it, or the only one.
    """
    names = packages.found(_bridges)
    found = _bridge_around(packages, launch) if names else None
    if found is not None:
        return found
    above = {_bridge_around(packages, path) for path in _including(packages, launch)} - {None}
    if len(above) == 1:
        return above.pop()
    return next(iter(names.values())) if len(names) == 1 else None


def _bridge_around(packages: MigratedPackages, launch: str) -> str | None:
    """The package with the file for the bridge that is a launch file's own, or the only one that it names."""
    names = packages.found(_bridges)
    own = package_around(os.path.dirname(launch)) or ""
    if own in names:
        return names[own]
    own_text = packages.read(launch).data
    for text in (own_text, b"".join(_texts_below(packages, own_text))):
        named = [name for name in names.values() if _is_named(name, text)]
        if len(named) == 1:
            return named[0]
    return None


def _including(packages: MigratedPackages, launch: str) -> Iterator[str]:
    """The launch files that name another one, and its package or no package."""
    folder = package_around(os.path.dirname(launch)) or ""
    own = package_name(os.path.join(folder, "package.xml")) or ""
    for path in packages.files(*_LAUNCHES):
        text = packages.read(path).data if path != launch and b"launch" in packages.read(path).data else b""
        if _is_named(os.path.basename(launch), text):
            yield from [path] if _is_named(own, text) or package_around(os.path.dirname(path)) == folder else []


def _bridges(packages: MigratedPackages) -> dict[str, str]:
    """The packages with a file for the bridge: their names by their folders."""
    found = [path for path in packages.files(BRIDGE_FILE) if _FORM in packages.read(path).data]
    folders = (folder for path in found if (folder := package_around(os.path.dirname(path))))
    return {folder: name for folder in folders if (name := package_name(os.path.join(folder, "package.xml")))}


def _texts_below(packages: MigratedPackages, text: bytes) -> Iterator[bytes]:
    """The launch files of the packages that a launch file names."""
    for path in packages.files("package.xml"):
        folder = os.path.dirname(path)
        name = package_name(path) if os.path.basename(path) == "package.xml" else None
        if name and _is_named(name, text):
            yield from (packages.read(one).data for one in packages.files(*_LAUNCHES) if _is_launch_of(one, folder))


def _is_launch_of(path: str, folder: str) -> bool:
    return path.startswith(folder + os.sep) and ".launch" in os.path.basename(path)


def _is_named(name: str, text: bytes) -> bool:
    return re.search(rb"(?<![\w-])" + re.escape(name.encode()) + rb"(?![\w-])", text) is not None
