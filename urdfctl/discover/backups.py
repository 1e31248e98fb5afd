"""Tell backups, copies and outputs of calibrations from the descriptions and controller files that a project uses."""

from __future__ import annotations

import os
import re

from urdfctl.source.disk.gate import is_file

_FOLDERS = frozenset(
    "archive archived archives attic backup backups bak deprecated discard discarded obsolete old trash unused".split()
)
_COPY = (
    r"(?i)(?P<stem>.*?)(?:[ _.-]*\(\d+\)|[ _.-]+copy(?:[ _-]?\d+)?|[ _.-]+(?:backup|bak|orig|original|old|save)\d*"
    r"|[ _.-]+(?:19|20)\d\d[-_]?\d\d[-_]?\d\d(?:[-_T]?\d+)*)(?P<end>(?:\.urdf)?\.(?:xacro|urdf)|\.ya?ml)"
)
"""The name of a copy: `arm(1).xacro`, `arm - Copy.urdf`, `arm_old.urdf.xacro`, `arm_2023-01-31.urdf`."""
_CALIBRATION = r"(?i)(?:^|[ _.-])(?:un)?calibrat(?:ed|ion)(?:[ _.-]|$)"


def is_backup(path: str) -> bool:
    """Return whether a description or controller file is kept aside: in a folder for that, or beside the file that it
    is a copy of; or whether a calibration wrote it."""
    folder, name = os.path.split(path)
    parts = os.path.relpath(path).split(os.sep)[:-1]
    is_below = os.pardir not in parts
    if (is_below and any(part.lower() in _FOLDERS for part in parts)) or re.search(_CALIBRATION, name):
        return True
    copy = re.fullmatch(_COPY, name)
    return copy is not None and is_file(os.path.join(folder, copy["stem"] + copy["end"]))
