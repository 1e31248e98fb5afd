"""The lists of repositories from which vcstool makes a workspace: `vcs import FOLDER < LIST.repos`."""

from __future__ import annotations

import os
import re

from urdfctl.source.disk.files import first_bytes, folders_upwards
from urdfctl.source.disk.gate import is_folder, names_in
from urdfctl.source.workspaces.workspace import workspace_of

_ENDINGS = (".repos", ".rosinstall")
_MOST_BYTES = 1 << 16
_NAMED = r"(?m)^ +[\"']?([\w./-]+?)[\"']?:[ \t]*(?:#.*)?$|\blocal-name:[ \t]*[\"']?([\w./-]+)"
"""A repository in the format of vcstool, which is a key of the map `repositories`, and in that of rosinstall."""
_URL = r"(?m)^\s+url:\s*\S*?([\w.-]+?)(?:\.git)?[\"']?\s*$|\buri:\s*\S*?([\w.-]+?)(?:\.git)?[\"',}\s]"


def list_with(package: str, file: str) -> tuple[str, str] | None:
    """Return the list of repositories above a file that has one with the name of a package, and the folder to import it
    to; None if there is none.

    It is imported to `src` beside the list, or else beside the folder of the list.
    """
    workspace = workspace_of(file)
    for folder in folders_upwards(os.path.dirname(os.path.abspath(file))):
        for path in (os.path.join(folder, name) for name in names_in(folder) if name.endswith(_ENDINGS)):
            if _plain(package) in _repositories(path):
                source = os.path.join(folder, "src")
                return path, source if is_folder(source) else os.path.dirname(folder)
        if folder == workspace:
            break
    return None


def _repositories(path: str) -> set[str]:
    """The names of the repositories in a list, and of the folders that their addresses end in."""
    text = first_bytes(path, _MOST_BYTES).decode(errors="replace")
    found = (name for pattern in (_NAMED, _URL) for groups in re.findall(pattern, text) for name in groups if name)
    return {_plain(os.path.basename(name)) for name in found}


def _plain(name: str) -> str:
    return name.replace("-", "_").lower()
