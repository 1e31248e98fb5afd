"""Finds messages that are cut off, and the one most like a text that is not known.

That takes a hundred times as long as finding whole ones, and is for pasted lines and for lines that look like errors.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable
from functools import cached_property, lru_cache

from urdfctl.logs.index import WORD, Hit, Index, Spelling, index
from urdfctl.logs.pattern import Match, Pattern, single_blanks

_MOST_CANDIDATES = 40
_LEAST_LETTERS = 16
_LONGEST_VALUE = 300
_LIKE_ENOUGH = 0.7
_ELLIPSES = re.compile(r"^(?:\.\.\.|…)\s*|\s*(?:\.\.\.|…)$")


class Partial:
    """What an index knows only in part."""

    def __init__(self, index: Index) -> None:
        self._index = index

    def cut(self, text: str) -> list[Hit]:
        """The messages that a text begins or ends within, those with the most letters of it; several where it does not
        decide between them."""
        text = _ELLIPSES.sub("", single_blanks(text))
        best: dict[str, tuple[int, Hit]] = {}
        for spelling in self._candidates(text):
            letters, match = _cut(spelling.pattern, text)
            known = best.get(spelling.message.id)
            if match is not None and letters >= _LEAST_LETTERS and (known is None or letters > known[0]):
                best[spelling.message.id] = (letters, Hit(spelling.message, spelling.pattern, match))
        most = max((letters for letters, _ in best.values()), default=0)
        return [hit for letters, hit in best.values() if letters == most]

    def nearest(self, text: str) -> Spelling | None:
        """The spelling most like a text, None where none is like it."""
        from difflib import SequenceMatcher

        words = [word.lower() for word in WORD.findall(text)]
        best, ratio = None, _LIKE_ENOUGH
        for spelling in self._candidates(text):
            literal = [word.lower() for word in WORD.findall(spelling.pattern.shown)]
            matcher = SequenceMatcher(None, literal, words, autojunk=False)
            same = sum(block.size for block in matcher.get_matching_blocks())
            # names stand in the gaps: words that the pattern lacks count for a half
            found = same / (len(literal) + max(0, len(words) - same - len(spelling.pattern.gaps)) / 2)
            if same > 2 and found >= ratio:  # noqa: PLR2004 (two words are no likeness)
                best, ratio = spelling, found
        return best

    @cached_property
    def _by_word(self) -> dict[str, list[int]]:
        numbers: dict[str, list[int]] = defaultdict(list)
        for number, spelling in enumerate(self._index.spellings):
            for word in {word.lower() for word in WORD.findall(spelling.pattern.shown)}:
                numbers[word].append(number)
        return numbers

    def _candidates(self, text: str) -> Iterable[Spelling]:
        """The spellings that share the rarest words with a text."""
        scores: Counter[int] = Counter()
        for word in {word.lower() for word in WORD.findall(text)}:
            numbers = self._by_word.get(word, ())
            for number in numbers:
                scores[number] += 1000 // len(numbers)
        return [self._index.spellings[number] for number, _ in scores.most_common(_MOST_CANDIDATES)]


@lru_cache(maxsize=1)
def partial() -> Partial:
    """What the index of all messages knows only in part."""
    return Partial(index())


def _cut(pattern: Pattern, text: str) -> tuple[int, Match | None]:
    """How many literal letters of a pattern are in a text that is cut at its end, or at its beginning, or at both."""
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
    """How many letters of the literals a text has, in their order, that ends before the last of them; 0 where it goes
    on otherwise. And the values between them, as far as they are whole."""
    letters, at = 0, 0
    values: list[str] = []
    for number, literal in enumerate(literals):
        start = text.find(literal, at)
        if start < 0:
            overlap = next((n for n in range(min(len(literal), len(text)), 0, -1) if text.endswith(literal[:n])), 0)
            value = text[at : len(text) - overlap]
            if number == 0:
                return overlap, []
            if len(value) > _LONGEST_VALUE or (not overlap and " " in value):
                return 0, []
            return letters + overlap, [*values, value] if overlap else values
        if number:
            values.append(text[at:start])
        letters, at = letters + len(literal), start + len(literal)
    return letters, values
