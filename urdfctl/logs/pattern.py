"""Patterns of messages: literal texts, with gaps between them for the values.

A gap is written `{joint}`, or `{joint:word}` if its value contains no blank, or `{joint:first}` for the first word of
what is there; `{}` has no name. Printed braces are
written twice. The literals are searched one after the other, so the time is always linear in the length of the line.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from urdfctl.startup.records import NamedTuple

_GAP = re.compile(r"\{\{|\}\}|\{(\w*)(:word|:first)?\}")
_OPENING, _CLOSING = ("'", '"', "["), ("'", '"', "]")
_VERB = re.compile(r"(?<=\S) (?:is|was|are|were|has|had|could|can|does|did)$")
_WRAPPED = re.compile(r"(?<=[a-z0-9]_) (?=[a-z0-9_]+$)|(?<=[a-z0-9]) (?=_[a-z0-9_]*$)")
"""A blank where a line was wrapped within a name."""
_AROUND_WORD = "',;:)]}\""
"""Marks behind a word that are not part of it."""


class Gap(NamedTuple):
    """A place for a value.

    name: empty if the value is not used. word: whether the value is a single word.
    first: whether the value is the first word of what is there.
    quoted: whether the value is printed between quotes or brackets, which a loose comparison does not see.
    """

    name: str
    word: bool = False
    first: bool = False
    quoted: bool = False


class MessagePattern(NamedTuple):
    """A message in parts.

    literals: the texts before, between and after the gaps; the first and last may be empty.
    """

    literals: tuple[str, ...]
    gaps: tuple[Gap, ...] = ()

    @property
    def weight(self) -> int:
        """The number of literal characters."""
        return sum(map(len, self.literals))

    @property
    def shown(self) -> str:
        """The message with an ellipsis in each gap."""
        return "…".join(self.literals)


class Match(NamedTuple):
    """The place of a pattern in a line, from its first literal to its last, and the values of its gaps by name."""

    start: int
    end: int
    values: Mapping[str, str]


def parsed(text: str) -> MessagePattern:
    """Return the pattern for a text of the catalogue."""
    literals, gaps, at = [""], [], 0
    text = single_blanks(text)
    for gap in _GAP.finditer(text):
        literals[-1] += text[at : gap.start()]
        at = gap.end()
        if gap[0] in {"{{", "}}"}:
            literals[-1] += gap[0][0]
        else:
            is_quoted = text[gap.start() - 1 : gap.start()] in _OPENING and text[gap.end() : gap.end() + 1] in _CLOSING
            gaps.append(Gap(gap[1], gap[2] == ":word", gap[2] == ":first", quoted=is_quoted))
            literals.append("")
    literals[-1] += text[at:]
    return MessagePattern(tuple(literals), tuple(gaps))


def filled(text: str, values: Mapping[str, str]) -> str:
    """Return a text of the catalogue with the values in its gaps, or an ellipsis if a value is unknown."""
    return _GAP.sub(lambda gap: values.get(gap[1], "…") if gap[1] is not None else gap[0][0], text)


def single_blanks(text: str) -> str:
    """Return a text with each run of blanks reduced to one, and none at its ends."""
    return " ".join(text.split())


def found_in(pattern: MessagePattern, line: str, source: str | None = None) -> Match | None:
    """Return the first match of a pattern in a line with single blanks, None if there is none.

    source: the line as it was, of the same length, from which the values are taken.
    """
    places, at = [], 0
    for literal in pattern.literals:
        start = line.find(literal, at)
        if start < 0:
            return None
        at = start + len(literal)
        places.append((start, at))
    literals = pattern.literals
    if len(literals) > 1 and literals[0] and literals[1]:  # the nearest to the second literal: the shortest value
        start = line.rfind(literals[0], places[0][0], places[1][0])
        places[0] = (start, start + len(literals[0]))
    values = _values(pattern, source or line, places)
    if values is None:
        return None
    start = places[0][0] if literals[0] else places[1][0]
    return Match(start, places[-1][1] if literals[-1] else places[-2][1], values)


def _values(pattern: MessagePattern, line: str, places: list[tuple[int, int]]) -> dict[str, str] | None:
    """The values of the gaps. A gap at the beginning gets the word before, a gap at the end the rest of the line."""
    values: dict[str, str] = {}
    for number, gap in enumerate(pattern.gaps):
        value = line[places[number][1] : places[number + 1][0]]
        if number == 0 and not pattern.literals[0]:
            value = value.rsplit(" ", 1)[-1]
        elif number == len(pattern.gaps) - 1 and not pattern.literals[-1]:
            value = line[places[number][1] :].strip()
        if gap.first:
            value = value.split(" ", 1)[0].rstrip(_AROUND_WORD) if value.strip() else ""
        if (gap.word or gap.first) and (not value or " " in value):
            return None
        if gap.name:
            values.setdefault(gap.name, _WRAPPED.sub("", _VERB.sub("", value)) if gap.quoted else value)
    return values
