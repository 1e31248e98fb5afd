"""Values of parameters as a catalogue's entry and a user's file give them, and whether they can be known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from urdfctl.source.opaque import UNKNOWN

_SUBSTITUTION = "$("
_NUMBERS = (bool, int, float)


def is_known(value: object) -> bool:
    """Whether a value could be worked out: it holds neither a substitution that only a launch makes nor the unknown."""
    if isinstance(value, str):
        return UNKNOWN not in value and _SUBSTITUTION not in value
    if type(value) in _NUMBERS:
        return True
    if isinstance(value, Mapping):
        return all(is_known(key) and is_known(part) for key, part in value.items())
    return all(is_known(part) for part in elements(value)) if is_list(value) else True


def is_list(value: object) -> bool:
    """Whether a value is a sequence, and no text."""
    if type(value) is list or type(value) in _NUMBERS:
        return type(value) is list
    return isinstance(value, Sequence) and not isinstance(value, str | bytes)


def elements(value: object) -> tuple[object, ...]:
    """The elements of a list; one of another value; none where it is absent or an empty text."""
    if is_list(value):
        return tuple(value)  # type: ignore[arg-type]
    return () if value is None or value == "" else (value,)


def is_set(value: object) -> bool:
    """Whether a value says something: it is there, and no empty text or list."""
    return bool(elements(value))
