"""Find the folders of packages below a folder."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from urdfctl.source.disk import gate

_IGNORE_FILES = frozenset({"COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE"})
_PRUNED = frozenset({"build", "install", "log", "devel", "node_modules", "__pycache__", "site-packages"})
_MOST_FOLDERS = 100_000


def package_folders(root: str) -> Iterator[str]:
    """Yield the folders below `root` that contain a package.xml. Like colcon, does not search inside a package."""
    for folder, folders, others in islice(gate.walk(root), _MOST_FOLDERS):
        is_package = "package.xml" in others
        if not _IGNORE_FILES.isdisjoint((*folders, *others)):
            folders.clear()
        elif is_package:
            yield folder
        if is_package and folder != root:
            folders.clear()
        folders[:] = filter(is_searched, folders)


def is_searched(name: str) -> bool:
    """Return whether a folder of this name may have packages below it: one that tools do not make or hide."""
    return not name.startswith(".") and name not in _PRUNED
