"""Values that cannot be known: what a macro's parameters are while nobody calls it.

A macro library is linted by calling its macros with such values. Whatever is worked out from one is one again, so no
rule can claim anything that depends on it.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.hints import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from typing import NoReturn


UNKNOWN = "\ue000"
"""Stands in a text for a value that could not be worked out; no rule may claim anything of such a text."""


def if_known(text: str) -> str | None:
    """A text, where all of it is known."""
    return None if UNKNOWN in text else text


class NotKnown(Exception):
    """Something needs to know a value that cannot be known: the whole expression is unknown then."""


class Opaque:
    """A value that is not known. Operators, attributes, items and calls give another; asking what it is raises."""

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
        """A value that is not known either."""
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
    """The arguments of a library: those that are given, and an unknown text for every other one."""

    def __missing__(self, name: str) -> str:
        return UNKNOWN

    def __contains__(self, name: object) -> bool:
        return dict.__contains__(self, name)
