"""Commands in launch files that print a robot description."""

from __future__ import annotations

import os
import re

from urdfctl.source.opaque import UNKNOWN, if_known

_XACRO = ("xacro", "xacro.py")
_SHELLS = ("sh", "bash")
_WORDS = r"(?:'[^']*'|\"[^\"]*\"|[^\s'\"]|['\"])+"


def of_command(command: str) -> tuple[str | None, tuple[tuple[str, str], ...] | None]:
    """Return the file that a `xacro` or `cat` command reads, and the arguments for xacro.

    A wrapper before the command is skipped. The file is None if the command is a different one, or the path is not
    fully known. The arguments are None if the command is a different one; the values of single ones may be unknown.
    """
    words = _words(command)
    if not words:
        return None, None
    files = [word for word in words[1:] if ":=" not in word and not word.startswith("-")]
    pairs = [word.partition(":=") for word in words[1:] if ":=" in word]
    arguments = tuple((name, value.strip("'\"")) for name, _, value in pairs)
    unknown = any(UNKNOWN in name for name, _ in arguments) or any(UNKNOWN in file for file in files[1:])
    path = known_path(files[0]) if len(files) == 1 else None
    return path, None if unknown else arguments


def runs_xacro(command: str) -> bool:
    """Return whether a command runs xacro, which expands any file."""
    words = _words(command)
    return bool(words) and words[0] != "cat"


def is_of_parameter(command: str) -> bool:
    """Return whether a command prints the robot description that another node has."""
    return bool(re.match(r"\s*(?:ros2\s+param|rosparam)\s+get\s.*\brobot_description\b", command))


def _words(command: str, depth: int = 0) -> list[str]:
    """The words of a command from `xacro` or `cat` on; none if it is a different command."""
    words = [re.sub(r"(['\"])(.*?)\1", r"\2", word) for word in re.findall(_WORDS, command)]
    if len(words) > 2 and os.path.basename(words[0]) in _SHELLS and words[1].endswith("c") and not depth:  # noqa: PLR2004
        return _words(words[2], depth + 1)
    if words and words[0] == "cat":
        return words
    programs = [index for index, word in enumerate(words) if os.path.basename(word) in _XACRO]
    return words[programs[-1] :] if programs else []  # the last one: `rosrun xacro xacro`


def known_path(text: str) -> str | None:
    """Return a path; None if it is empty or not fully known."""
    return if_known(text) or None
