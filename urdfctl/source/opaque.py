"""Unknown values: the parameters of a macro that has no call.

A macro library is linted by calling its macros with unknown values. Any expression with an unknown value gives an
unknown value, so that no rule reports anything that depends on one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any, NoReturn

_NONE: Mapping[str, str] = MappingProxyType({})
UNKNOWN = "\ue000"
"""The character in a text that represents an unknown value. No rule may report anything that depends on such a text."""
OUTSIDE = rf"{UNKNOWN}\(([\w-]+)\)"
"""A package whose folder is not known, in a command or a path."""


def if_known(text: str) -> str | None:
    """Return the text; None if part of it is unknown."""
    return None if UNKNOWN in text else text


def is_known(*texts: str | None) -> bool:
    """Return whether all texts are fully known. A text with UNKNOWN in it must not be judged."""
    return not any(text and UNKNOWN in text for text in texts)


class NotKnown(Exception):
    """An operation needs the value of an unknown, so the whole expression is unknown."""


class Opaque:
    """An unknown value.

    Operators, attributes, items and calls return an unknown value again. Converting it, e.g. to bool or int, raises
    NotKnown.
    """

    __slots__ = ()

    def __str__(self) -> str:
        return UNKNOWN

    __repr__ = __str__

    def __getattr__(self, name: str) -> Opaque:
        if name.startswith("_"):
            raise AttributeError(name)
        return self

    def __getitem__(self, key: object) -> Opaque:
        return self

    def __call__(self, *_: object, **__: object) -> Opaque:
        """Return an unknown value."""
        return self

    def _itself(self, *_: object) -> Opaque:
        return self

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = _itself
    __floordiv__ = __rfloordiv__ = __mod__ = __rmod__ = __pow__ = __rpow__ = __neg__ = __pos__ = __abs__ = _itself
    __and__ = __rand__ = __or__ = __ror__ = __xor__ = __rxor__ = __invert__ = __round__ = _itself
    __lt__ = __le__ = __gt__ = __ge__ = _itself
    __hash__ = None  # type: ignore[assignment]

    def __eq__(self, other: object) -> Any:
        return self

    def __ne__(self, other: object) -> Any:
        return self

    def _asked(self, *_: object) -> NoReturn:
        raise NotKnown

    __bool__ = __int__ = __float__ = __index__ = __len__ = __contains__ = _asked

    def __iter__(self) -> Iterator[Opaque]:
        raise NotKnown


class AnyArgument(dict[str, str]):
    """The given arguments, and an unknown text for any other name. Those names are kept in `asked`."""

    def __init__(self, given: Mapping[str, str] = _NONE) -> None:
        super().__init__(given)
        self.asked: dict[str, None] = {}

    def __missing__(self, name: str) -> str:
        self.asked[name] = None
        return UNKNOWN

    def __contains__(self, name: object) -> bool:
        return dict.__contains__(self, name)
