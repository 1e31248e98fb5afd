"""Random edits of texts, as people make them in an editor: half finished, wrong, pasted, and taken back."""

from __future__ import annotations

import random
import re
from collections.abc import Sequence

_LETTERS = '<>"/${}: \n\t-#&ax1é🤖\0'
_FRAGMENTS = ("<joint ", "</robot>", "${", "$(find ", "<xacro:macro ", "- ", "<!--", "&amp;", "1e999", "*a", "\r\n")
_MOST_PASTED = 400
_MOST_BYTES = 300_000


def edited(text: str, rng: random.Random, others: Sequence[str] = ()) -> str:
    """Return a text with one random edit: letters, words, lines or blocks are deleted, inserted, moved or replaced.

    others: texts that fragments are pasted from.
    """
    edit = rng.choice(_EDITS)
    changed = edit(text, rng) if edit is not _pasted else _pasted(text, rng, others or (text,))
    return changed if len(changed) < _MOST_BYTES else changed[: _MOST_BYTES // 2]


def _deleted(text: str, rng: random.Random) -> str:
    start = rng.randrange(len(text) + 1)
    return text[:start] + text[start + rng.randrange(1, 12) :]


def _typed(text: str, rng: random.Random) -> str:
    start = rng.randrange(len(text) + 1)
    return text[:start] + rng.choice([*_LETTERS, *_FRAGMENTS]) + text[start:]


def _without_lines(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True) or [""]
    start = rng.randrange(len(lines))
    del lines[start : start + rng.choice([1, 1, 1, 5, len(lines)])]
    return "".join(lines)


def _with_moved_lines(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True) or [""]
    start, to = rng.randrange(len(lines)), rng.randrange(len(lines))
    block = lines[start : start + rng.randrange(1, 6)]
    if rng.random() < 1 / 2:
        del lines[start : start + len(block)]
    return "".join([*lines[:to], *block, *lines[to:]])


def _with_other_word(text: str, rng: random.Random) -> str:
    words = re.findall(r"\w+", text)
    if not words:
        return text + "\n"
    word = rng.choice(words)
    return text.replace(word, rng.choice([f"{word}x", word[:-1], rng.choice(words)]), rng.choice([1, 1, -1]))


def _with_other_number(text: str, rng: random.Random) -> str:
    numbers = list(re.finditer(r"\d+(?:\.\d+)?", text))
    if not numbers:
        return text + "0"
    number = rng.choice(numbers)
    return text[: number.start()] + rng.choice(["0", "-1", "1.0", "", "nan", "1e3", "${pi"]) + text[number.end() :]


def _pasted(text: str, rng: random.Random, others: Sequence[str] = ()) -> str:
    other, at = rng.choice(others or (text,)), rng.randrange(len(text) + 1)
    start = rng.randrange(len(other) + 1)
    return text[:at] + other[start : start + rng.randrange(_MOST_PASTED)] + text[at:]


_EDITS = (
    *(_deleted, _typed, _typed, _without_lines, _with_moved_lines),
    *(_with_other_word, _with_other_word, _with_other_number, _pasted),
)
