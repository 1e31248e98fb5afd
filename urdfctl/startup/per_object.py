"""Decorators that cache a function's result per argument object.

Saves: several rules compute the same facts about one robot. The arguments are compared by identity, so they need not be
hashable.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import TypeVar

_Argument = TypeVar("_Argument")
_Result = TypeVar("_Result")

_MOST = 256


def once_per_object(function: Callable[[_Argument], _Result], most: int = _MOST) -> Callable[[_Argument], _Result]:
    """Return the function with its results cached per argument object, for up to `most` objects.

    The arguments are compared by identity. They need not be hashable, and must not change.
    """
    cache: dict[int, tuple[_Argument, _Result]] = {}

    @wraps(function)
    def cached(argument: _Argument) -> _Result:
        entry = cache.get(id(argument))
        if entry is None:
            if len(cache) >= most:
                cache.clear()
            entry = cache[id(argument)] = (argument, function(argument))
        return entry[1]

    return cached


def once_for_the_last(function: Callable[[_Argument], _Result]) -> Callable[[_Argument], _Result]:
    """Return the function with the result for its last argument object cached.

    For arguments such as robots: several rules in a row ask for the same one, and a run has too many to cache them all.
    """
    return once_per_object(function, most=1)
