"""Names with an unknown part, as findings quote them: shown as they are written in the source."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfctl.diagnostic import Finding, Note
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place, SourceText

_WRITTEN = rb"""(?:\b([\w:]+)\s*=\s*["']|>)\s*([^"'<>]*\$[({][^<>"]*?)\s*["'<]"""
_EXPRESSION = r"\$\{[^}]*\}|\$\([^)]*\)"
_QUOTED = f"'([^']*{UNKNOWN}[^']*)'"
_BARE = f"[^\\s'<>\"{UNKNOWN}]*{UNKNOWN}[^\\s'<>\"]*"
_NAMING = ("name", "reference", "link", "joint")


def as_written(finding: Finding, sources: Iterable[SourceText]) -> Finding | None:
    """Return a finding whose quoted names are as they are written in the source, where part of them is unknown.

    None if something else that the finding says is unknown, or a name is not found in the source.
    """
    names = _Names(finding.at, sources)
    message = names.replaced_in(finding.message)
    if UNKNOWN in message:
        return None
    notes = (Note(names.replaced_in(note.message), note.at) for note in finding.notes)
    fix = finding.fix
    if fix is not None and any(UNKNOWN in text for text in (fix.title, *(edit.text for edit in fix.edits))):
        fix = None
    return finding._replace(
        message=message, notes=tuple(note for note in notes if UNKNOWN not in note.message), fix=fix
    )


class _Names:
    """The texts with expressions around a place, nearest first, then those in other files."""

    def __init__(self, at: Place, sources: Iterable[SourceText]) -> None:
        self._at, self._sources = at, sources
        self._known: list[tuple[str, str]] | None = None

    def replaced_in(self, message: str) -> str:
        """Return a message with the names in it as they are written, as far as they are found."""
        quoted = re.sub(_QUOTED, lambda found: f"'{self._written(found[1], is_name=True)}'", message)
        return re.sub(_BARE, lambda found: self._written(found[0]), quoted)

    def _written(self, text: str, *, is_name: bool = False) -> str:
        """The text as it is written; the text itself if it is not found, or may be anything."""
        if self._known is None:
            self._known = list(self._texts())
        if text.strip(UNKNOWN):
            return next((written for _, written in self._known if _may_become(written, text)), text)
        named = (written for attribute, written in self._known if attribute in _NAMING and _is_unknown(written))
        return next(named, text) if is_name else text

    def _texts(self) -> Iterator[tuple[str, str]]:
        """The attribute (empty for the content of an element) and the text."""
        own = self._at.source
        found = list(re.finditer(_WRITTEN, own.data))
        end = self._at.span.end
        before = [match for match in found if match.start(2) < end]
        after = [match for match in found if match.start(2) >= end]
        elsewhere = (
            match for source in self._sources if source is not own for match in re.finditer(_WRITTEN, source.data)
        )
        for match in (*reversed(before), *after, *elsewhere):
            yield (match[1] or b"").decode("utf-8", "replace"), match[2].decode("utf-8", "replace")


def _may_become(written: str, name: str) -> bool:
    """Whether a text with expressions may become a name part of which is unknown."""
    literals = re.split(_EXPRESSION, written)
    return any(literals) and (_fits(name.split(UNKNOWN), written) or _fits(literals, name))


def _is_unknown(written: str) -> bool:
    return not any(re.split(_EXPRESSION, written))


def _fits(parts: list[str], text: str) -> bool:
    return re.fullmatch("(?s:.*)".join(map(re.escape, parts)), text) is not None
