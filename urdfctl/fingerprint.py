"""What a finding is known by although lines move: its rule, its file, its message, and the source line under it."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable
from hashlib import sha256

from urdfctl.diagnostic import Diagnostic

_LENGTH = 32


def mark(diagnostic: Diagnostic, folder: str) -> str:
    """What a finding is known by, as 32 hexadecimal digits; alike findings on alike lines share it. Paths count from a
    folder, so that the mark is the same wherever the folder stands.

    One in a macro is told of whichever call comes first among the robots of a run, so its names do not count there.
    """
    message = re.sub(r"\bline \d+", "line", message_from(diagnostic, folder))
    if diagnostic.in_macro:
        message = re.sub(r"'[^']*'", "''", message)
    parts = diagnostic.code, path_from(diagnostic.at.file, folder), message, " ".join(diagnostic.excerpt.split())
    return sha256("\0".join(parts).encode("utf-8", "surrogatepass")).hexdigest()[:_LENGTH]


def fingerprints(diagnostics: Iterable[Diagnostic], folder: str) -> list[str]:
    """A mark for each finding, unlike any other of them: alike ones are counted."""
    seen: Counter[str] = Counter()
    marks = []
    for diagnostic in diagnostics:
        one = mark(diagnostic, folder)
        seen[one] += 1
        again = sha256(f"{one} {seen[one]}".encode()).hexdigest()[:_LENGTH]
        marks.append(one if seen[one] == 1 else again)
    return marks


def message_from(diagnostic: Diagnostic, folder: str) -> str:
    """A message whose paths count from a folder."""
    return diagnostic.message.replace(folder.rstrip(os.sep) + os.sep, "")


def path_from(path: str, folder: str) -> str:
    """A path as seen from a folder, with forward slashes."""
    try:
        return os.path.relpath(path, folder).replace(os.sep, "/")
    except ValueError:  # on another drive
        return path.replace(os.sep, "/")
