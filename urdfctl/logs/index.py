"""Find the known messages in a line. Each is indexed by a rare word, so most lines take only microseconds."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from functools import lru_cache

from urdfctl.catalog.log_messages import LogMessage, log_messages
from urdfctl.logs.line import cleaned
from urdfctl.logs.loose import loosened, lower
from urdfctl.logs.pattern import Match, MessagePattern, found_in, parsed, single_blanks
from urdfctl.startup.records import NamedTuple

WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9]{2,}")
_LEAST_LOOSE = 16
"""Letters that a pattern for loose comparison must have."""
_REASONS = ("failure", "warning")


class Spelling(NamedTuple):
    """One of a message's patterns."""

    message: LogMessage
    pattern: MessagePattern

    @property
    def words(self) -> set[str]:
        """The words that every line with this pattern contains: those not adjacent to a gap."""
        literals = self.pattern.literals
        last = len(literals) - 1
        return {
            word[0]
            for number, literal in enumerate(literals)
            for word in WORD.finditer(literal)
            if (number == 0 or word.start()) and (number == last or word.end() < len(literal))
        }


class Hit(NamedTuple):
    """A message in a line."""

    message: LogMessage
    pattern: MessagePattern
    match: Match


class Index:
    """All patterns of the messages, indexed by their rarest word.

    loose: compare without quotes, articles and capitals; patterns that say little then are left out.
    """

    def __init__(self, messages: Iterable[LogMessage], *, loose: bool = False) -> None:
        self._loose = loose
        spellings = [Spelling(message, parsed(cleaned(text))) for message in messages for text in message.patterns]
        self.spellings = [one for one in map(_loose, spellings) if one is not None] if loose else spellings
        self.words = [spelling.words for spelling in self.spellings]
        self.frequency = Counter(word for words in self.words for word in words)
        self._by_anchor: dict[str, list[Spelling]] = defaultdict(list)
        for spelling, words in zip(self.spellings, self.words, strict=True):
            anchor = min(words, key=lambda word: (self.frequency[word], -len(word), word))
            self._by_anchor[anchor].append(spelling)

    def candidates(self, line: str) -> list[Spelling]:
        """Return the patterns whose rarest word is in the line; only these can match."""
        words = self._by_anchor.keys() & set(WORD.findall(line))
        return [spelling for word in words for spelling in self._by_anchor[word]]

    def hits(self, line: str) -> list[Hit]:
        """Return the messages in a line, in order, without messages that are part of longer ones.

        Consequences are omitted if the line also contains another kind of message.
        """
        line, source = (lower(loosened(line)), loosened(line)) if self._loose else (line, line)
        candidates = self.candidates(line)
        return found_among(candidates, line, source) if candidates else []


def found_among(spellings: Iterable[Spelling], line: str, source: str | None = None) -> list[Hit]:
    """Return the given patterns that are in a line, filtered like `Index.hits`.

    source: the line with its capitals, from which the values are taken.
    """
    line, source = single_blanks(line), single_blanks(source or line)
    hits = [
        Hit(spelling.message, spelling.pattern, match)
        for spelling in spellings
        if (match := found_in(spelling.pattern, line, source)) is not None
    ]
    return _without_consequences(_without_parts(hits)) if len(hits) > 1 else hits


def _without_consequences(hits: list[Hit]) -> list[Hit]:
    """The hits without consequences whose reason is there too, with the values that these name; else the innermost."""
    consequences = [hit for hit in hits if hit.message.kind == "consequence"]
    if not any(hit.message.kind in _REASONS for hit in hits):
        return [hit for hit in hits if hit not in consequences[:-1]]
    values = {name: value for hit in consequences for name, value in hit.match.values.items()}
    others = [hit for hit in hits if hit not in consequences]
    return [_with(hit, values) for hit in others] if values else others


def _with(hit: Hit, values: Mapping[str, str]) -> Hit:
    """A hit with those additional values that its texts use."""
    used = {name: value for name, value in values.items() if f"{{{name}}}" in hit.message.meaning + hit.message.fix}
    return hit._replace(match=hit.match._replace(values={**used, **hit.match.values}))


def _without_parts(hits: list[Hit]) -> list[Hit]:
    """The hits that are not part of a longer hit, in the order of the line."""
    kept: list[Hit] = []
    for hit in sorted(hits, key=lambda hit: (hit.match.start - hit.match.end, -hit.pattern.weight)):
        if not any(other.match.start <= hit.match.start and hit.match.end <= other.match.end for other in kept):
            kept.append(hit)
    return sorted(kept, key=lambda hit: hit.match.start)


def _loose(spelling: Spelling) -> Spelling | None:
    """A pattern for loose comparison, or None if too little of it is left to be sure."""
    literals = [lower(loosened(literal)) for literal in spelling.pattern.literals]
    literals[-1] = literals[-1].rstrip(" .!:")
    pattern = spelling.pattern._replace(literals=tuple(map(_single, literals)))
    loose = spelling._replace(pattern=pattern)
    return loose if pattern.weight >= _LEAST_LOOSE and loose.words else None


def _single(literal: str) -> str:
    """A literal with single blanks, also at its ends."""
    return re.sub(r"\s+", " ", literal)


@lru_cache(maxsize=1)
def index() -> Index:
    """Return the index of all messages in the catalogue."""
    return Index(log_messages())


@lru_cache(maxsize=1)
def loose_index() -> Index:
    """Return the index of all messages in the catalogue for loose comparison."""
    return Index(log_messages(), loose=True)
