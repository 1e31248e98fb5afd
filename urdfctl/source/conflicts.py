"""Merge conflicts that were left in a file, which no parser reads."""

from __future__ import annotations

import re

from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place, SourceText

_FIRST = rb"^<{7}(?: [^\r\n]*)?(?=\r?$)"
_LAST = rb"^>{7}(?: [^\r\n]*)?(?=\r?$)"


def merge_conflict(source: SourceText) -> Problem | None:
    """Return the problem of a file with the marks that git leaves around a conflict; None if there is none."""
    first = re.search(_FIRST, source.data, re.MULTILINE)
    last = re.search(_LAST, source.data, re.MULTILINE)
    if first is None or last is None or last.start() < first.start():
        return None
    line = source.position(last.start()).line
    message = f"a merge conflict was left in the file; it ends in line {line}"
    at = Place(source, first.start(), end=first.end())
    return Problem(ProblemKind.MERGE_CONFLICT, at, message, hint="keep one side of it, and remove the marks of git")
