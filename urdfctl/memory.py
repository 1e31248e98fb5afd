"""What was worked out once for an object, kept for who asks again of the same one."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps

from urdfctl.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import TypeVar

    _Asked = TypeVar("_Asked")
    _Seen = TypeVar("_Seen")

_MOST = 256


def once_per_object(function: Callable[[_Asked], _Seen], most: int = _MOST) -> Callable[[_Asked], _Seen]:
    """Remember what a function gave for the objects that it was asked of, a few hundred of them: told apart as
    objects, so that they need not be hashable, and must not change."""
    known: dict[int, tuple[_Asked, _Seen]] = {}

    @wraps(function)
    def remembered(asked: _Asked) -> _Seen:
        found = known.get(id(asked))
        if found is None:
            if len(known) >= most:
                known.clear()
            found = known[id(asked)] = (asked, function(asked))
        return found[1]

    return remembered


def once_for_the_last(function: Callable[[_Asked], _Seen]) -> Callable[[_Asked], _Seen]:
    """Remember what a function gave for the object that it was last asked of, such as a robot: several rules ask the
    same of each, one by one, and a run has too many of them to keep."""
    return once_per_object(function, most=1)
