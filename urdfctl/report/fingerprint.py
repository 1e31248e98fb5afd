"""Fingerprints of findings that survive moved lines: rule, file, message, and text of the source line."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable
from hashlib import sha256

from urdfctl.diagnostic import Diagnostic

_LENGTH = 32


def mark(diagnostic: Diagnostic, folder: str) -> str:
    """Return a finding's fingerprint, 32 hexadecimal digits. Equal findings on equal lines share it.

    Paths are relative to `folder`, so that the fingerprint does not depend on where the folder is. A finding in a macro
    is reported for the first call in a run, which can differ between runs, so names in its message are ignored.
    """
    message = re.sub(r"\bline \d+", "line", message_from(diagnostic, folder))
    if diagnostic.in_macro:
        message = re.sub(r"'[^']*'", "''", message)
    parts = diagnostic.code, path_from(diagnostic.at.file, folder), message, " ".join(diagnostic.excerpt.split())
    return sha256("\0".join(parts).encode("utf-8", "surrogatepass")).hexdigest()[:_LENGTH]


def fingerprints(diagnostics: Iterable[Diagnostic], folder: str) -> list[str]:
    """Return a unique fingerprint for each finding; equal findings are numbered."""
    seen: Counter[str] = Counter()
    marks = []
    for diagnostic in diagnostics:
        shared = mark(diagnostic, folder)
        seen[shared] += 1
        numbered = sha256(f"{shared} {seen[shared]}".encode()).hexdigest()[:_LENGTH]
        marks.append(shared if seen[shared] == 1 else numbered)
    return marks


def message_from(diagnostic: Diagnostic, folder: str) -> str:
    """Return a message with paths relative to a folder."""
    return diagnostic.message.replace(folder.rstrip(os.sep) + os.sep, "")


def path_from(path: str, folder: str) -> str:
    """Return a path relative to a folder, with forward slashes."""
    try:
        return os.path.relpath(path, folder).replace(os.sep, "/")
    except ValueError:  # the folder is on another drive
        return path.replace(os.sep, "/")
