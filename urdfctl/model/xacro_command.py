"""The commands of launch files that make a robot description."""

from __future__ import annotations

import os
import re

from urdfctl.source.opaque import UNKNOWN, if_known

_XACRO = ("xacro", "xacro.py")
_WORDS = r"(?:'[^']*'|\"[^\"]*\"|[^\s'\"]|['\"])+"


def of_command(command: str) -> tuple[str | None, tuple[tuple[str, str], ...] | None]:
    """The file that a command prints or expands, and the arguments it gives to xacro."""
    words = [re.sub(r"(['\"])(.*?)\1", r"\2", word) for word in re.findall(_WORDS, command)]
    for run in (["rosrun", "xacro"], ["ros2", "run", "xacro"]):
        words = words[len(run) :] if words[: len(run)] == run else words
    if not words or os.path.basename(words[0]) not in (*_XACRO, "cat"):
        return None, None
    files = [word for word in words[1:] if ":=" not in word and not word.startswith("-")]
    pairs = [word.partition(":=") for word in words[1:] if ":=" in word]
    arguments = tuple((name, value.strip("'\"")) for name, _, value in pairs)
    unknown = any(UNKNOWN in word for word in words[1:] if word not in files)
    path = known_path(files[0]) if len(files) == 1 else None
    return path, None if unknown else arguments


def known_path(text: str) -> str | None:
    """A path, where all of it is known and it is not empty."""
    return if_known(text) or None
