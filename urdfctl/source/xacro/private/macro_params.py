"""Split the `params` of a macro as xacro does, but in linear time: xacro's own pattern can take minutes."""

from __future__ import annotations

import re
from collections.abc import Callable

from urdfctl.source.xacro.expressions.guards import ForbiddenExpression

Split = tuple[str, tuple[str | None, str | None] | None, str]
"""The name of a parameter, its forwarding and default (or None), and the rest of the params."""

_LONGEST = 20_000
_NAME = r"\s*([^\s:=]+?)\s*:?=\s*"
_BRACED = (r"\$\{.*?\}(?=\s|$)", r"\$\(.*?\)(?=\s|$)")


def split_quickly(original: Callable[[str], Split]) -> Callable[[str], Split]:
    """Return a fast parse_macro_arg. Texts without quotes go to xacro's own, which is slow only for quotes."""

    def split(text: str) -> Split:
        if len(text) > _LONGEST:
            raise ForbiddenExpression(f"the params of a macro are longer than {_LONGEST} characters")
        return split_first(text) if "'" in text or '"' in text else original(text)

    return split


def split_first(text: str) -> Split:
    """Return the first parameter of a macro's `params`. IndexError if there is none, as in xacro."""
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
    """Return where the default that begins at an offset ends; None if there is none."""
    for pattern in _BRACED:
        braced = re.compile(pattern).match(text, start)
        if braced:
            return braced.end()
    return _ends_of_words(text, start)


def _ends_of_words(text: str, start: int) -> int | None:
    """Return where the word that begins at an offset ends; None if it does not end.

    Quotes within a word can contain blanks. A quote is closed by a later one of its kind on its line, the nearest
    first; from there the word continues to a blank or the end. The text is scanned from the right, so that each
    character only needs the results of its neighbour and of the next closing quotes.
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
