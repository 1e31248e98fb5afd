"""Find the known messages in a line. Each is indexed by a rare word, so most lines take only microseconds."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from functools import lru_cache

from urdfctl.catalog.log_messages import LogMessage, log_messages
from urdfctl.logs.pattern import Match, Pattern, found_in, parsed, single_blanks
from urdfctl.startup.records import NamedTuple

WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9]{2,}")


class Spelling(NamedTuple):
    """One of a message's patterns."""

    message: LogMessage
    pattern: Pattern

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
    pattern: Pattern
    match: Match


class Index:
    """All patterns of the messages, indexed by their rarest word."""

    def __init__(self, messages: Iterable[LogMessage]) -> None:
        self.spellings = [Spelling(message, parsed(text)) for message in messages for text in message.patterns]
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
        candidates = self.candidates(line)
        return found_among(candidates, line) if candidates else []


def found_among(spellings: Iterable[Spelling], line: str) -> list[Hit]:
    """Return the given patterns that are in a line, filtered like `Index.hits`."""
    line = single_blanks(line)
    hits = [
        Hit(spelling.message, spelling.pattern, match)
        for spelling in spellings
        if (match := found_in(spelling.pattern, line)) is not None
    ]
    return _without_consequences(_without_parts(hits)) if len(hits) > 1 else hits


def _without_consequences(hits: list[Hit]) -> list[Hit]:
    """The hits that are not consequences, with the values that the omitted consequences name."""
    reasons = [hit for hit in hits if hit.message.kind != "consequence"]
    if not reasons:
        return hits[:1]
    values = {name: value for hit in hits if hit not in reasons for name, value in hit.match.values.items()}
    return [_with(hit, values) for hit in reasons] if values else reasons


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


@lru_cache(maxsize=1)
def index() -> Index:
    """Return the index of all messages in the catalogue."""
    return Index(log_messages())
