"""Guard expressions against endless work and access to the interpreter: operators, ranges, types, math."""

from __future__ import annotations

import builtins
import math
import re
from collections.abc import Callable, Iterable, Sequence
from types import ModuleType
from typing import Any

from urdfctl.source.opaque import Opaque

MOST_PLACES = 10_000
LONGEST_VALUE = 1 << 20
_LONGEST_RANGE = 1_000_000
_MOST_BITS = 1 << 16
_MOST_FACTORS = 10_000
_CALLING = ("filter", "map", "max", "min", "sorted")
"""Functions that call functions that they are given."""
_DATA = (int, float, complex, str, bytes, list, tuple, dict, set, frozenset, range, slice, type(None), Opaque)
"""xacro's namespaces and its wrappers of YAML are dicts and lists too."""
_PADDING = frozenset("ljust rjust center zfill expandtabs".split())
LENGTHENING = frozenset((*_PADDING, "join", "format", "replace", "translate"))
"""Methods that can make a long text of a short one."""
_WIDE = r"\d{5,}"
_WIDE_FORMAT = r"%[^%a-zA-Z]*(\d{5,}|\*)"


class ForbiddenExpression(Exception):
    """An expression does something that robot descriptions do not need."""


class MissingVariable(Exception):
    """`$(env X)` of a variable that is not set, or that descriptions cannot read."""


def times(left: Any, right: Any) -> Any:
    """Return `left * right`. ForbiddenExpression if the number or text is unreasonably large."""
    if type(left) is not float and type(right) is not float:
        if isinstance(left, int) and isinstance(right, int):
            _check_bits(left.bit_length() + right.bit_length())
        elif isinstance(left, int) and isinstance(right, str | bytes | list | tuple):
            _check_length(len(right) * left)
        elif isinstance(right, int) and isinstance(left, str | bytes | list | tuple):
            _check_length(len(left) * right)
    return left * right


def power(left: Any, right: Any) -> Any:
    """Return `left ** right`. ForbiddenExpression if the number is unreasonably large."""
    if isinstance(left, int) and isinstance(right, int) and abs(left) > 1:
        _check_bits(left.bit_length() * right)
    return left**right


def shifted(left: Any, right: Any) -> Any:
    """Return `left << right`. ForbiddenExpression if the number is unreasonably large."""
    if isinstance(left, int) and isinstance(right, int):
        _check_bits(left.bit_length() + right)
    return left << right


def check_filled(pattern: str | bytes, letters: int) -> None:
    """Raise ForbiddenExpression if `pattern % values` is unreasonably wide, or long: a value may be filled in often.

    letters: how many the texts of all values have.
    """
    text = pattern if isinstance(pattern, str) else pattern.decode("latin-1")
    if re.search(_WIDE_FORMAT, text):
        raise ForbiddenExpression("'%' with a computed or large width is not allowed in an expression")
    _check_length(len(text) + letters * text.count("%"))


def check_method(of: Any, name: str, given: Sequence[Any], letters: Callable[[Any], int]) -> None:
    """Raise ForbiddenExpression if a method in LENGTHENING would make an unreasonably long text.

    of: the text or bytes whose method it is.
    given: the arguments.
    letters: returns how many letters the text of an argument may have.
    """
    length = len(of)
    if name == "join":
        length = length * len(given[0]) + sum(map(letters, given[0]))
    elif name == "format":
        length += sum(map(letters, given)) * of.count("{")
    elif name == "replace" and len(given) > 1:
        length += (length // max(letters(given[0]), 1) + 1) * letters(given[1])
    elif name == "translate" and isinstance(given[0], dict):
        length *= max(map(letters, given[0].values()), default=1)
    elif any(isinstance(width, int) and width > MOST_PLACES for width in given):
        length = LONGEST_VALUE + 1
    _check_length(length)


def attribute(value: Any, name: str) -> Any:
    """Return `value.name` if the value is data. ForbiddenExpression for functions and internal objects."""
    if isinstance(value, _DATA) or (isinstance(value, type) and issubclass(value, _DATA)):
        return getattr(value, name)
    raise ForbiddenExpression(f"the attribute '{name}' of a {type(value).__name__} is not allowed in an expression")


def check_places(spec: str) -> None:
    """Raise ForbiddenExpression if a format asks for tens of thousands of digits."""
    if re.search(_WIDE, spec):
        raise ForbiddenExpression("a format width of 10000 or more is not allowed in an expression")


def _check_bits(bits: int) -> None:
    if bits > _MOST_BITS:
        raise ForbiddenExpression("the expression computes a number that is too large")


def _check_length(length: int) -> None:
    if length > LONGEST_VALUE:
        raise ForbiddenExpression("the expression creates a string or list that is too large")


def _range(*arguments: Any) -> range:
    found = range(*arguments)
    if found and abs(found[-1] - found[0]) // abs(found.step) >= _LONGEST_RANGE:
        raise ForbiddenExpression("the expression creates a range that is too large")
    return found


def _type(value: Any) -> type:
    """Return the type of data. The type of a function or a type would give access to the interpreter."""
    if value is not None and (not isinstance(value, _DATA) or isinstance(value, bytes)):
        raise ForbiddenExpression("'type' of a value that is not data is not allowed in an expression")
    return type(value)


def _round(number: Any, ndigits: Any = None) -> Any:
    if isinstance(ndigits, int) and abs(ndigits) > MOST_PLACES:
        raise ForbiddenExpression("the number of digits to round to is too large")
    return round(number, ndigits)


def _vars(*_: Any) -> None:
    raise ForbiddenExpression("'vars' is not allowed in an expression")


def _sum(values: Iterable[Any], /, start: Any = 0) -> Any:
    if isinstance(start, int | float | complex):
        return sum(values, start)
    for value in values:
        start = start + value
        _check_length(len(start) if isinstance(start, list | tuple) else 0)
    return start


def harmless_builtins(calling: Callable[[Any], Any]) -> dict[str, Any]:
    """Return Python's builtins, of which xacro exposes some.

    calling: makes a function that another one calls one whose calls are counted.
    """

    def counting(function: Callable[..., Any]) -> Callable[..., Any]:
        def counted(*arguments: Any, **keywords: Any) -> Any:
            return function(*map(calling, arguments), **{name: calling(value) for name, value in keywords.items()})

        return counted

    calls = {name: counting(vars(builtins)[name]) for name in _CALLING}
    guarded = {"range": _range, "round": _round, "sum": _sum, "type": _type, "vars": _vars}
    return {**vars(builtins), **calls, **guarded}


def _few(function: Callable[..., Any]) -> Callable[..., Any]:
    def few(*numbers: Any) -> Any:
        if any(isinstance(number, int) and number > _MOST_FACTORS for number in numbers):
            raise ForbiddenExpression(f"'{function.__name__}' of a large number is not allowed in an expression")
        return function(*numbers)

    return few


def _product(values: Iterable[Any], *, start: Any = 1) -> Any:
    for value in values:
        start = times(start, value)
    return start


def harmless_math() -> ModuleType:
    """Return a copy of the module math, with guards for the functions that make large numbers."""
    guarded = ModuleType("math")
    guarded.__dict__.update(vars(math))
    for name in ("factorial", "comb", "perm"):
        setattr(guarded, name, _few(getattr(math, name)))
    guarded.prod = _product  # type: ignore[attr-defined]
    return guarded


def tokenized(tokenize: Callable[..., list[str]]) -> Callable[..., list[str]]:
    """Return xacro's tokenize, guarded. It puts the separators into a character set, so they must not end it."""

    def guarded(s: Any, sep: str = ",; ", skip_empty: Any = True) -> list[str]:  # noqa: FBT002 (xacro's signature)
        if "]" in sep or "\\" in sep:
            raise ForbiddenExpression("']' and '\\' are not allowed as separators")
        return tokenize(s, sep, skip_empty)

    return guarded
