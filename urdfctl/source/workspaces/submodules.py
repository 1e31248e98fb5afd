"""The submodules of a git repository that were not fetched with it."""

from __future__ import annotations

import os
import re

from urdfctl.source.disk.files import first_bytes, folders_upwards
from urdfctl.source.disk.gate import entries_in, is_file

_MOST_BYTES = 1 << 16
_PATH = r"(?m)^\s*path\s*=\s*(\w[\w./-]*?)/?\s*$"


def empty_submodule(package: str, file: str) -> tuple[str, str] | None:
    """Return the repository around a file, and in it the path of an empty submodule with the name of a package.

    None if there is none. `git clone` leaves the folders of submodules empty unless it is told to fetch them
    (git-clone, --recurse-submodules).
    """
    for root in folders_upwards(os.path.dirname(os.path.abspath(file))):
        listed = os.path.join(root, ".gitmodules")
        if not is_file(listed):
            continue
        paths = re.findall(_PATH, first_bytes(listed, _MOST_BYTES).decode(errors="replace"))
        named = (path for path in paths if _plain(os.path.basename(path)) == _plain(package))
        return next(((root, path) for path in named if not entries_in(os.path.join(root, path))), None)
    return None


def _plain(name: str) -> str:
    return name.replace("-", "_").lower()
