"""The one gate for paths that are written: a link that a stranger committed leads no output out of its workspace."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator

from urdfctl.errors import UserError
from urdfctl.source.disk.files import folders_upwards
from urdfctl.source.workspaces.workspace import workspace_around


def destination(path: str) -> str:
    """Return where to write what is meant for a path: the path with all links followed.

    Raises UserError if a symbolic link on the way is in a workspace and leads out of it, or to the files of git. Links
    in no workspace are the user's or the system's own, such as /tmp or /dev/stdout, and are followed.
    """
    for link in _links(path, set()):
        leads_to = os.path.realpath(link)
        workspace = workspace_around(os.path.realpath(os.path.dirname(link)))
        if workspace is None:
            continue
        if not _is_in(leads_to, workspace):
            raise UserError(_refusal(path, link, f"leads out of the workspace, to '{leads_to}'"))
        if _is_in(leads_to, os.path.join(workspace, ".git")):
            raise UserError(_refusal(path, link, f"leads to what belongs to git, '{leads_to}'"))
    real = os.path.realpath(path)
    if os.path.islink(real):
        raise UserError(f"'{path}' cannot be written: {os.strerror(errno.ELOOP)}")
    return real


def check_output(*paths: str | None) -> None:
    """Raise UserError if a file to write leads out of its workspace: before the work, and before others are written."""
    for path in filter(None, paths):
        destination(path)


def _links(path: str, seen: set[str]) -> Iterator[str]:
    """Yield the symbolic links that a path leads through, and those that each of them leads through."""
    for place in reversed([path, *folders_upwards(os.path.dirname(path))]):
        if place not in seen and os.path.islink(place):
            seen.add(place)
            yield place
            yield from _links(os.path.join(os.path.dirname(place), os.readlink(place)), seen)


def _is_in(path: str, folder: str) -> bool:
    return path == folder or path.startswith(folder.rstrip(os.sep) + os.sep)


def _refusal(path: str, link: str, leads: str) -> str:
    how = f"'{link}' is a symbolic link that {leads}"
    return f"'{path}' is not written: {how}; delete the link, or name another file"
