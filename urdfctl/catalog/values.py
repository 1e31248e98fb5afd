"""Parameter values from a catalogue entry or a user's file, and whether they are known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from urdfctl.source.opaque import UNKNOWN

_SUBSTITUTION = "$("
_NUMBERS = (bool, int, float)


def is_known(value: object) -> bool:
    """Return whether a value is known: it contains neither a launch substitution nor UNKNOWN."""
    if isinstance(value, str):
        return UNKNOWN not in value and _SUBSTITUTION not in value
    if type(value) in _NUMBERS:
        return True
    if isinstance(value, Mapping):
        return all(is_known(key) and is_known(part) for key, part in value.items())
    return all(is_known(part) for part in elements(value)) if is_list(value) else True


def is_list(value: object) -> bool:
    """Return whether a value is a sequence other than a string."""
    if type(value) is list or type(value) in _NUMBERS:
        return type(value) is list
    return isinstance(value, Sequence) and not isinstance(value, str | bytes)


def elements(value: object) -> tuple[object, ...]:
    """Return the elements of a list, or another value as the only element; empty for None and the empty string."""
    if is_list(value):
        return tuple(value)  # type: ignore[arg-type]
    return () if value is None or value == "" else (value,)


def is_set(value: object) -> bool:
    """Return whether a value is given and neither an empty string nor an empty list."""
    return bool(elements(value))
