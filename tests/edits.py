"""Random edits of texts, as people make them in an editor: half finished, wrong, and taken back."""

from __future__ import annotations

import random
import re


def edited(text: str, rng: random.Random) -> str:
    """Return a text with one random edit: letters, a line or a name is deleted, inserted or replaced."""
    start = rng.randrange(len(text) + 1)
    kind = rng.randrange(6)
    words = re.findall(r"\w+", text)
    if kind == 0:
        return text[:start] + text[start + rng.randrange(1, 12) :]
    if kind == 1:
        return text[:start] + rng.choice('<>"/${}: \nax1é🤖') + text[start:]
    if kind == 2:
        lines = text.splitlines(keepends=True) or [""]
        del lines[rng.randrange(len(lines))]
        return "".join(lines)
    if not words:
        return text + "\n"
    word = rng.choice(words)
    return text.replace(word, rng.choice([f"{word}x", word[:-1], rng.choice(words)]), 1)
