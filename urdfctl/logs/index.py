"""Finds the known messages in a line: by a rare word of each, so that most lines are done with in microseconds."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from functools import lru_cache

from urdfctl.catalog.log_messages import LogMessage, log_messages
from urdfctl.logs.pattern import Match, Pattern, found_in, parsed, single_blanks
from urdfctl.record import NamedTuple

WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9]{2,}")


class Spelling(NamedTuple):
    """One of a message's patterns."""

    message: LogMessage
    pattern: Pattern

    @property
    def words(self) -> set[str]:
        """The words that every line with it holds: those that no gap touches."""
        literals = self.pattern.literals
        last = len(literals) - 1
        return {
            found[0]
            for number, literal in enumerate(literals)
            for found in WORD.finditer(literal)
            if (number == 0 or found.start()) and (number == last or found.end() < len(literal))
        }


class Hit(NamedTuple):
    """A message in a line."""

    message: LogMessage
    pattern: Pattern
    match: Match


class Index:
    """All spellings of the messages, by their rarest words."""

    def __init__(self, messages: Iterable[LogMessage]) -> None:
        self.spellings = [Spelling(message, parsed(text)) for message in messages for text in message.patterns]
        self.words = [spelling.words for spelling in self.spellings]
        self.frequency = Counter(word for words in self.words for word in words)
        self._by_anchor: dict[str, list[Spelling]] = defaultdict(list)
        for spelling, words in zip(self.spellings, self.words, strict=True):
            anchor = min(words, key=lambda word: (self.frequency[word], -len(word), word))
            self._by_anchor[anchor].append(spelling)

    def candidates(self, line: str) -> list[Spelling]:
        """The spellings that may be in a line: those whose rarest word is."""
        words = self._by_anchor.keys() & set(WORD.findall(line))
        return [spelling for word in words for spelling in self._by_anchor[word]]

    def hits(self, line: str) -> list[Hit]:
        """The messages in a line, in their order, without those that are parts of others; what only follows from
        another failure is left out where the line tells of that too."""
        candidates = self.candidates(line)
        return found_among(candidates, line) if candidates else []


def found_among(spellings: Iterable[Spelling], line: str) -> list[Hit]:
    """Those of some spellings that are in a line, as `Index.hits` gives them."""
    line = single_blanks(line)
    found = [
        Hit(spelling.message, spelling.pattern, match)
        for spelling in spellings
        if (match := found_in(spelling.pattern, line)) is not None
    ]
    return _telling(_whole(found)) if len(found) > 1 else found


def _telling(found: list[Hit]) -> list[Hit]:
    """The hits that tell why: the others only stand around them. What those name is known of these too."""
    own = [hit for hit in found if hit.message.kind != "consequence"]
    if not own:
        return found[:1]
    around = {name: value for hit in found if hit not in own for name, value in hit.match.values.items()}
    return [_with(hit, around) for hit in own] if around else own


def _with(hit: Hit, around: Mapping[str, str]) -> Hit:
    """A hit with those values from around it that its own texts ask for."""
    asked = {name: value for name, value in around.items() if f"{{{name}}}" in hit.message.meaning + hit.message.fix}
    return hit._replace(match=hit.match._replace(values={**asked, **hit.match.values}))


def _whole(found: list[Hit]) -> list[Hit]:
    """The hits that are no part of a longer one, in the order of the line."""
    kept: list[Hit] = []
    for hit in sorted(found, key=lambda hit: (hit.match.start - hit.match.end, -hit.pattern.weight)):
        if not any(other.match.start <= hit.match.start and hit.match.end <= other.match.end for other in kept):
            kept.append(hit)
    return sorted(kept, key=lambda hit: hit.match.start)


@lru_cache(maxsize=1)
def index() -> Index:
    """The index of all messages of the catalogue."""
    return Index(log_messages())
