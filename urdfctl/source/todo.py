"""The mark of what a migration leaves to a person."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.source.span import Place, SourceText

MARK = "TODO(urdfctl):"
_MARK = b"TODO(urdfctl)"
_COMMENT = rb"TODO\(urdfctl\)(?::| -) *([^\r\n]*?) *(?:-->|\r|\n|\Z)"


def has_todos(text: bytes) -> bool:
    """Return whether a text may have TODOs of a migration."""
    return _MARK in text


def todos_in(source: SourceText) -> Iterator[tuple[str, Place]]:
    """Yield the text of each TODO of a migration in a file, with the place of its comment.

    A dash instead of the colon is as good: Gazebo Classic's plugin cannot pass on a colon in humble.
    """
    if has_todos(source.data):
        for match in re.finditer(_COMMENT, source.data):
            text = match[1].decode("utf-8", "replace")
            yield text, Place(source, match.start(), end=match.end(1))
