"""The built-in functions of Python that count: `range`, `enumerate`, `zip`, `reversed`, `len` and `int`."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from urdfctl.source.launch.operations import listed
from urdfctl.source.launch.terms import MOST_ITEMS, Constant, Items, Perhaps, Term, UnknownTerm
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place


def counted(name: str, arguments: Sequence[Term], at: Place) -> Term | None:
    """Return the term of a call of one of these functions; None for any other function."""
    function = _FUNCTIONS.get(name)
    if function is None:
        return None
    return function(arguments, at) or UnknownTerm(at)


def _range(arguments: Sequence[Term], at: Place) -> Term | None:
    numbers = [_number(argument) for argument in arguments]
    whole = [number for number in numbers if number is not None]
    if len(whole) < len(numbers) or not 1 <= len(whole) <= 3 or whole[2:] == [0]:  # noqa: PLR2004 (start, stop, step)
        return None
    values = range(*whole)
    return Items([Constant(value, at) for value in values], at) if len(values) <= MOST_ITEMS else None


def _enumerate(arguments: Sequence[Term], at: Place) -> Term | None:
    items = _sure(arguments[0]) if arguments else None
    start = _number(arguments[1]) if arguments[1:] else 0
    if items is None or start is None:
        return None
    return Items([Items([Constant(number, at), item], at) for number, item in enumerate(items, start)], at)


def _zip(arguments: Sequence[Term], at: Place) -> Term | None:
    lists = [_sure(argument) for argument in arguments]
    known = [items for items in lists if items is not None]
    if len(known) < len(lists):
        return None
    return Items([Items(together, at) for together in zip(*known, strict=False)], at)


def _reversed(arguments: Sequence[Term], at: Place) -> Term | None:
    items = listed(arguments[0]) if len(arguments) == 1 else None
    return None if items is None else Items(items[::-1], at)


def _len(arguments: Sequence[Term], at: Place) -> Term | None:
    items = _sure(arguments[0]) if len(arguments) == 1 else None
    return None if items is None else Constant(len(items), at)


def _int(arguments: Sequence[Term], at: Place) -> Term | None:
    number = _number(arguments[0]) if len(arguments) == 1 else None
    return None if number is None else Constant(number, at)


def _sure(term: Term) -> list[Term] | None:
    """The items of a list that is wholly known."""
    items = listed(term)
    return None if items is None or any(isinstance(item, Perhaps) for item in items) else items


def _number(term: Term) -> int | None:
    value = term.value if isinstance(term, Constant) else None
    if isinstance(value, str) and UNKNOWN not in value and value.strip().isdecimal():
        return int(value) if len(value) < _MOST_DIGITS else None
    return value if isinstance(value, int) else None


_MOST_DIGITS = 10
_FUNCTIONS: dict[str, Callable[[Sequence[Term], Place], Term | None]] = {
    "range": _range,
    "enumerate": _enumerate,
    "zip": _zip,
    "reversed": _reversed,
    "len": _len,
    "int": _int,
}
