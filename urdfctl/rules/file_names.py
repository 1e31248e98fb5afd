"""The names of files, and the one that was probably meant where a file does not exist."""

from __future__ import annotations

import re

from urdfctl.model.controllers import FileReference
from urdfctl.names import is_slip
from urdfctl.rule import Fix
from urdfctl.rules.common import replaced


def file_name(path: str) -> str:
    """Return the last part of a path of any platform."""
    return re.split(r"[/\\]", path)[-1]


def meant_file(reference: FileReference) -> str:
    """Return the end of a message about a file that does not exist: the file beside it that was probably meant."""
    return f"; did you mean '{reference.nearest}'?" if reference.nearest else ""


def file_renamed(reference: FileReference) -> Fix | None:
    """Return the fix that names the file that was probably meant: safe if one letter is wrong."""
    name, written = file_name(reference.path or ""), reference.at.span.text
    if not reference.nearest or not name:
        return None
    if written.count(name) != 1:
        return Fix(f"write '{reference.nearest}'")
    is_sure = is_slip(name, reference.nearest)
    return replaced(reference.at.part(name), name, reference.nearest, safe=is_sure)
