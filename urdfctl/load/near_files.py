"""The file that was probably meant where one does not exist."""

from __future__ import annotations

import os

from urdfctl.names import is_slip, nearest
from urdfctl.source.disk.gate import names_in


def file_near(path: str) -> str:
    """Return the name of the file beside one that does not exist, with the same ending and a similar name; empty if
    there is none, or two differ from it by one letter."""
    folder, name = os.path.split(path)
    stem, dot, ending = name.partition(".")
    try:
        beside = [each.removesuffix(dot + ending) for each in names_in(folder) if dot and each.endswith(dot + ending)]
    except OSError:
        return ""
    slips = [each for each in beside if is_slip(stem, each)]
    meant = None if len(slips) > 1 else nearest(stem, beside)
    return f"{meant}{dot}{ending}" if meant else ""
