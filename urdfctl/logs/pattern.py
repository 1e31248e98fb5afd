"""A message as its source prints it: literal texts, and gaps between them where values are put in.

Gaps are written `{joint}`, or `{joint:word}` where the value holds no blank; `{}` has no name. Braces that are printed
are written twice. The texts are looked for one after the other, so that the time is linear in the line's length
whatever stands in it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from urdfctl.record import NamedTuple

_GAP = re.compile(r"\{\{|\}\}|\{(\w*)(:word)?\}")


class Gap(NamedTuple):
    """A place for a value: its name, empty where nobody asks for it, and whether the value is a single word."""

    name: str
    word: bool = False


class Pattern(NamedTuple):
    """A message in parts: a literal text before, between and behind the gaps; the outer ones may be empty."""

    literals: tuple[str, ...]
    gaps: tuple[Gap, ...] = ()

    @property
    def weight(self) -> int:
        """How many of its characters are literal."""
        return sum(map(len, self.literals))

    @property
    def shown(self) -> str:
        """The message with an ellipsis in each gap."""
        return "…".join(self.literals)


class Match(NamedTuple):
    """Where a pattern stands in a line, from its first literal to its last, and the values in its gaps by name."""

    start: int
    end: int
    values: Mapping[str, str]


def parsed(text: str) -> Pattern:
    """The pattern that a text of the data means."""
    literals, gaps, at = [""], [], 0
    text = single_blanks(text)
    for found in _GAP.finditer(text):
        literals[-1] += text[at : found.start()]
        at = found.end()
        if found[0] in {"{{", "}}"}:
            literals[-1] += found[0][0]
        else:
            gaps.append(Gap(found[1], found[2] is not None))
            literals.append("")
    literals[-1] += text[at:]
    return Pattern(tuple(literals), tuple(gaps))


def filled(text: str, values: Mapping[str, str]) -> str:
    """A text of the data with the values in its gaps; an ellipsis where one is not known."""
    return _GAP.sub(lambda gap: values.get(gap[1], "…") if gap[1] is not None else gap[0][0], text)


def single_blanks(text: str) -> str:
    """A text without blanks around it, and with one blank for each run of them."""
    return " ".join(text.split())


def found_in(pattern: Pattern, line: str) -> Match | None:
    """The first place of a pattern in a line whose blanks are single, None where it is not in it."""
    places, at = [], 0
    for literal in pattern.literals:
        start = line.find(literal, at)
        if start < 0:
            return None
        at = start + len(literal)
        places.append((start, at))
    literals = pattern.literals
    if len(literals) > 1 and literals[0] and literals[1]:  # the nearest to the second one: the shortest first value
        start = line.rfind(literals[0], places[0][0], places[1][0])
        places[0] = (start, start + len(literals[0]))
    values = _values(pattern, line, places)
    if values is None:
        return None
    start = places[0][0] if literals[0] else places[1][0]
    return Match(start, places[-1][1] if literals[-1] else places[-2][1], values)


def _values(pattern: Pattern, line: str, places: list[tuple[int, int]]) -> dict[str, str] | None:
    """What stands in the gaps; a gap at the beginning takes the word before, one at the end the rest of the line."""
    values: dict[str, str] = {}
    for number, gap in enumerate(pattern.gaps):
        value = line[places[number][1] : places[number + 1][0]]
        if number == 0 and not pattern.literals[0]:
            value = value.rsplit(" ", 1)[-1]
        elif number == len(pattern.gaps) - 1 and not pattern.literals[-1]:
            value = line[places[number][1] :].strip()
        if gap.word and (not value or " " in value):
            return None
        if gap.name:
            values.setdefault(gap.name, value)
    return values
