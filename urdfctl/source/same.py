"""Compare values that were read twice from the same texts."""

from __future__ import annotations

from urdfctl.source.span import Place

_ATOMS = (str, int, float, bool, bytes)


def is_same(value: object, other: object) -> bool:
    """Return whether two values are the same object, or are made of the same texts, numbers and places.

    Tuples and records are compared by their elements. Anything else that is not the same object counts as different:
    it may take long to compare.
    """
    if value is other:
        return True
    if type(value) is not type(other):
        return False
    if isinstance(value, tuple) and isinstance(other, tuple):
        return len(value) == len(other) and all(map(is_same, value, other))
    if isinstance(value, Place) and isinstance(other, Place):
        return value.is_same(other)
    return isinstance(value, _ATOMS) and value == other
