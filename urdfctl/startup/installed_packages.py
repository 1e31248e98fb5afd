"""Entry points of the packages that are installed beside urdfctl.

Only the folders of this Python's own packages are looked at: neither the linted files nor PYTHONPATH, which may lead to
them, can bring code along.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint


def entry_points_of(group: str) -> Iterator[tuple[str, EntryPoint]]:
    """Yield each entry point of a group with the name and version of its distribution, in the order of the names."""
    folders = [folder for folder in _package_folders() if _has_group(folder, group)]
    if not folders:
        return
    from importlib.metadata import distributions  # 20 ms, for those who have some

    for distribution in sorted(distributions(path=folders), key=lambda one: one.name):
        for entry in distribution.entry_points.select(group=group):
            yield f"{distribution.name} {distribution.version}", entry


def _package_folders() -> list[str]:
    """The folders where this Python keeps installed packages."""
    own = [sys.prefix, sys.base_prefix]
    site = sys.modules.get("site")
    if site is not None and site.ENABLE_USER_SITE:
        own.append(site.getuserbase())
    return [
        entry
        for entry in dict.fromkeys(sys.path)
        if os.path.basename(entry) in ("site-packages", "dist-packages")
        and any(entry.startswith(prefix.rstrip(os.sep) + os.sep) for prefix in own)
    ]


def _has_group(folder: str, group: str) -> bool:
    """Whether an installed package has entry points of a group. This takes 1 ms for 100 packages."""
    try:
        with os.scandir(folder) as entries:
            infos = [entry.path for entry in entries if entry.name.endswith((".dist-info", ".egg-info"))]
    except OSError:
        return False
    header = f"[{group}]".encode()
    return any(_mentions(os.path.join(info, "entry_points.txt"), header) for info in infos)


def _mentions(path: str, header: bytes) -> bool:
    try:
        with open(path, "rb") as file:
            return header in file.read().replace(b" ", b"")
    except OSError:
        return False
