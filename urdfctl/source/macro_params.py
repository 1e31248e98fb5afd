"""Splits the `params` of a macro as xacro does, in linear time: its own pattern takes minutes over a stray quote."""

from __future__ import annotations

import re
from collections.abc import Callable

from urdfctl.source.guards import ForbiddenExpression

Split = tuple[str, tuple[str | None, str | None] | None, str]
"""A parameter's name; what it forwards and its default, or nothing; and the rest of the params."""

_LONGEST = 20_000
_NAME = r"\s*([^\s:=]+?)\s*:?=\s*"
_BRACED = (r"\$\{.*?\}(?=\s|$)", r"\$\(.*?\)(?=\s|$)")


def split_quickly(original: Callable[[str], Split]) -> Callable[[str], Split]:
    """Xacro's parse_macro_arg, but for texts with quotes: without them its pattern has nothing to retry."""

    def split(text: str) -> Split:
        if len(text) > _LONGEST:
            raise ForbiddenExpression(f"the params of a macro are longer than {_LONGEST} characters")
        return split_first(text) if "'" in text or '"' in text else original(text)

    return split


def split_first(text: str) -> Split:
    """The first parameter of a macro's `params`. IndexError where there is none, as in xacro."""
    name = re.match(_NAME, text)
    if name is None:
        return _without_default(text)
    for forward in ("^|", "^", ""):
        start = name.end() + len(forward)
        end = _end_of_default(text, start) if text.startswith(forward, name.end()) else None
        if end is not None:
            return name[1], (name[1] if forward else None, text[start:end] or None), _rest(text, end)
    if text[name.end() - 1].isspace():  # nothing fits behind the blanks: the default is empty, as if one blank ended it
        return name[1], (None, None), _rest(text, name.end() - 1)
    return _without_default(text)


def _without_default(text: str) -> Split:
    words = text.lstrip().split(None, 1)
    return words[0], None, words[1] if len(words) > 1 else ""


def _end_of_default(text: str, start: int) -> int | None:
    """Where the default that begins at an offset ends; None where none does."""
    for pattern in _BRACED:
        braced = re.compile(pattern).match(text, start)
        if braced:
            return braced.end()
    return _ends_of_words(text, start)


def _ends_of_words(text: str, start: int) -> int | None:
    """Where the word that begins at an offset ends. Quotes within a word hold blanks; a quote may close at any later
    one of its kind on its line, the nearest first, from which the word goes on to a blank or the end.

    Looked at from the right, each character needs to know only what its neighbour and the next closing quotes found.
    """
    end: int | None = len(text)
    closing: dict[str, int | None] = {"'": None, '"': None}
    for offset in range(len(text) - 1, start - 1, -1):
        character = text[offset]
        if character in closing:
            behind, end = end, closing[character]
            if behind is not None:
                closing[character] = behind
        elif character.isspace():
            end = offset
            if character == "\n":
                closing = {"'": None, '"': None}
    return end


def _rest(text: str, end: int) -> str:
    return text[end:].lstrip().partition("\n")[0]
