"""Find truncated messages, and the known message most similar to an unknown text.

This takes a hundred times as long as finding complete messages, so it is used only for pasted lines and lines that look
like errors.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable
from functools import cached_property, lru_cache

from urdfctl.logs.index import WORD, Hit, Index, Spelling, index
from urdfctl.logs.loose import loosened
from urdfctl.logs.pattern import Match, MessagePattern, single_blanks

_MOST_CANDIDATES = 40
"""Patterns compared with a text."""
_LEAST_LETTERS = 16
"""Letters that a truncated text must share with a pattern."""
_LEAST_OVERLAP = 0.6
"""Share of a text that must be the beginning of a message if no more of the message is in it."""
_LONGEST_VALUE = 300
_SURE_SIMILARITY = 0.8
"""Share of words that a text must have in common with a pattern to be taken for its message."""
_SURE_WORDS = 5
"""Words that it must have in common."""
_ELLIPSES = re.compile(r"^(?:\.\.\.|…)\s*|\s*(?:\.\.\.|…)$")


class Partial:
    """Search an index for messages that match only partly."""

    def __init__(self, index: Index) -> None:
        self._index = index

    def cut(self, text: str) -> list[Hit]:
        """Return the messages in which the text begins or ends, with the most matching letters; several if they tie."""
        text = _ELLIPSES.sub("", single_blanks(text))
        best: dict[str, tuple[int, Hit]] = {}
        for spelling in self._candidates(text):
            letters, match = _cut(spelling.pattern, text)
            known = best.get(spelling.message.id)
            if match is not None and letters >= _LEAST_LETTERS and (known is None or letters > known[0]):
                best[spelling.message.id] = (letters, Hit(spelling.message, spelling.pattern, match))
        most = max((letters for letters, _ in best.values()), default=0)
        return [hit for letters, hit in best.values() if letters == most]

    def similar(self, text: str) -> list[Hit]:
        """Return the message that a text surely means although some of its words differ, if there is one."""
        spelling = self.nearest(text, _SURE_SIMILARITY, _SURE_WORDS)
        return [Hit(spelling.message, spelling.pattern, Match(0, len(text), {}))] if spelling else []

    def nearest(self, text: str, least: float = 0.7, words_in_common: int = 3) -> Spelling | None:
        """Return the pattern most similar to a text, None if none is similar enough.

        least: the share of words that they must have in common, from 0 to 1.
        """
        from difflib import SequenceMatcher

        words = [word.lower() for word in WORD.findall(loosened(text))]
        best, ratio = None, least
        for spelling in self._candidates(text):
            literal = [word.lower() for word in WORD.findall(loosened(spelling.pattern.shown))]
            matcher = SequenceMatcher(None, literal, words, autojunk=False)
            same = sum(block.size for block in matcher.get_matching_blocks())
            # Gaps contain names, so words that are not in the pattern count half.
            similarity = same / (len(literal) + max(0, len(words) - same - len(spelling.pattern.gaps)) / 2)
            if same >= words_in_common and similarity >= ratio:
                best, ratio = spelling, similarity
        return best

    @cached_property
    def _by_word(self) -> dict[str, list[int]]:
        numbers: dict[str, list[int]] = defaultdict(list)
        for number, spelling in enumerate(self._index.spellings):
            if spelling.message.kind == "progress":
                continue
            for word in {word.lower() for word in WORD.findall(spelling.pattern.shown)}:
                numbers[word].append(number)
        return numbers

    def _candidates(self, text: str) -> Iterable[Spelling]:
        """The patterns that share the rarest words with a text."""
        scores: Counter[int] = Counter()
        for word in {word.lower() for word in WORD.findall(text)}:
            numbers = self._by_word.get(word, ())
            for number in numbers:
                scores[number] += 1000 // len(numbers)
        return [self._index.spellings[number] for number, _ in scores.most_common(_MOST_CANDIDATES)]


@lru_cache(maxsize=1)
def partial() -> Partial:
    """Return the partial search in all messages of the catalogue."""
    return Partial(index())


def _cut(pattern: MessagePattern, text: str) -> tuple[int, Match | None]:
    """The number of literal letters of a pattern in a text that is truncated at its end, its beginning or both."""
    whole = max(pattern.literals, key=len)
    if len(text) < len(whole) and text in whole:
        return len(text), Match(0, len(text), {})
    letters, values = _ends_within(pattern.literals, text)
    names = [gap.name for gap in pattern.gaps]
    if letters < _LEAST_LETTERS:
        letters, values = _ends_within(tuple(literal[::-1] for literal in pattern.literals[::-1]), text[::-1])
        names, values = names[::-1], [value[::-1] for value in values]
    if not letters:
        return 0, None
    return letters, Match(0, len(text), {name: value for name, value in zip(names, values, strict=False) if name})


def _ends_within(literals: tuple[str, ...], text: str) -> tuple[int, list[str]]:
    """How many letters of the literals a truncated text contains in order, and the complete values between them.

    The number is 0 if the text continues differently.
    """
    letters, at = 0, 0
    values: list[str] = []
    for number, literal in enumerate(literals):
        start = text.find(literal, at)
        if start < 0:
            overlap = next((n for n in range(min(len(literal), len(text)), 0, -1) if text.endswith(literal[:n])), 0)
            value = text[at : len(text) - overlap]
            if number == 0:
                return (overlap, []) if overlap >= _LEAST_OVERLAP * len(text) else (0, [])
            if len(value) > _LONGEST_VALUE or (not overlap and " " in value):
                return 0, []
            return letters + overlap, [*values, value] if overlap else values
        if number:
            values.append(text[at:start])
        letters, at = letters + len(literal), start + len(literal)
    return letters, values
