"""Bound the length of a text that is made of others: from value to value, a text can double."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

MOST_CHARACTERS = 1 << 16
"""No text in a real launch file is longer."""
TOO_LONG = f"a value here becomes longer than {MOST_CHARACTERS} characters; it is not followed further"


class Room:
    """How much longer a text may become while it is made."""

    def __init__(self) -> None:
        self._left = MOST_CHARACTERS

    @property
    def is_over(self) -> bool:
        """Whether more was taken than there was room for."""
        return self._left < 0

    def take(self, text: str) -> str:
        """Return a part of the text; nothing once there is no room."""
        self._left -= len(text)
        return "" if self.is_over else text


def until_too_long(parts: Iterable[str]) -> Iterator[str]:
    """Yield the parts of a text, but none after those that make it longer than MOST_CHARACTERS."""
    length = 0
    for part in parts:
        yield part
        length += len(part)
        if length > MOST_CHARACTERS:
            return
