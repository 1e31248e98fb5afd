"""Stands between expressions and what would make them endless, or lead out of them: operators, ranges, types, math."""

from __future__ import annotations

import builtins
import math
import re
from collections.abc import Callable, Iterable
from types import ModuleType

from urdfctl.hints import Any
from urdfctl.source.opaque import Opaque

MOST_PLACES = 10_000
LONGEST_VALUE = 1 << 20
_LONGEST_RANGE = 1_000_000
_MOST_BITS = 1 << 16
_MOST_FACTORS = 10_000
_DATA = (int, float, complex, str, bytes, list, tuple, dict, set, frozenset, range, slice, type(None), Opaque)
"""xacro's namespaces and what it makes of YAML are dicts and lists too."""
_WIDE = r"\d{5,}"
_WIDE_FORMAT = r"%[^%a-zA-Z]*(\d{5,}|\*)"


class ForbiddenExpression(Exception):
    """An expression does what none in a robot description needs."""


def times(left: Any, right: Any) -> Any:
    """`left * right`, unless that is a number or a text of no use to anybody."""
    if type(left) is not float and type(right) is not float:
        if isinstance(left, int) and isinstance(right, int):
            _check_bits(left.bit_length() + right.bit_length())
        elif isinstance(left, int) and isinstance(right, str | bytes | list | tuple):
            _check_length(len(right) * left)
        elif isinstance(right, int) and isinstance(left, str | bytes | list | tuple):
            _check_length(len(left) * right)
    return left * right


def power(left: Any, right: Any) -> Any:
    """`left ** right`, unless that is a number of no use to anybody."""
    if isinstance(left, int) and isinstance(right, int) and abs(left) > 1:
        _check_bits(left.bit_length() * right)
    return left**right


def shifted(left: Any, right: Any) -> Any:
    """`left << right`, unless that is a number of no use to anybody."""
    if isinstance(left, int) and isinstance(right, int):
        _check_bits(left.bit_length() + right)
    return left << right


def remainder(left: Any, right: Any) -> Any:
    """`left % right`; where that formats a text, not to a width of no use to anybody."""
    if isinstance(left, str | bytes) and re.search(
        _WIDE_FORMAT, left if isinstance(left, str) else left.decode("latin-1")
    ):
        raise ForbiddenExpression("'%' to a computed or large width is not allowed in an expression")
    return left % right


def attribute(value: Any, name: str) -> Any:
    """`value.name`, where the value is data; what functions and objects of ours have is nobody's business."""
    if isinstance(value, _DATA) or (isinstance(value, type) and issubclass(value, _DATA)):
        return getattr(value, name)
    raise ForbiddenExpression(f"the attribute '{name}' of a {type(value).__name__} is not allowed in an expression")


GUARDS: tuple[Callable[[Any, Any], Any], ...] = (attribute, times, power, shifted, remainder)
"""In the order of `expressions.OPERATORS`."""


def check_places(spec: str) -> None:
    """ForbiddenExpression where a format asks for tens of thousands of places."""
    if re.search(_WIDE, spec):
        raise ForbiddenExpression("a format of ten thousand places is not allowed in an expression")


def checked(value: Any) -> Any:
    """The value of an expression, unless it is larger than any robot needs: the next one would double it."""
    if isinstance(value, str | bytes | list | tuple | dict) and len(value) > LONGEST_VALUE:
        raise ForbiddenExpression("the value of the expression is too large")
    return value


def _check_bits(bits: int) -> None:
    if bits > _MOST_BITS:
        raise ForbiddenExpression("the number that the expression asks for is too large")


def _check_length(length: int) -> None:
    if length > LONGEST_VALUE:
        raise ForbiddenExpression("the text or list that the expression asks for is too large")


def _range(*arguments: Any) -> range:
    found = range(*arguments)
    if found and abs(found[-1] - found[0]) // abs(found.step) >= _LONGEST_RANGE:
        raise ForbiddenExpression("the range that the expression asks for is too large")
    return found


def _type(value: Any) -> type:
    """The type of data; that of a function or a type would lead into the interpreter."""
    if value is not None and not isinstance(value, _DATA):
        raise ForbiddenExpression("'type' of anything but data is not allowed in an expression")
    return type(value)


def _round(number: Any, ndigits: Any = None) -> Any:
    if isinstance(ndigits, int) and abs(ndigits) > MOST_PLACES:
        raise ForbiddenExpression("the number of digits to round to is too large")
    return round(number, ndigits)


def _vars(*_: Any) -> None:
    raise ForbiddenExpression("'vars' is not allowed in an expression")


def harmless_builtins() -> dict[str, Any]:
    """Python's builtins, for xacro to choose from those that it exposes."""
    return {**vars(builtins), "range": _range, "round": _round, "type": _type, "vars": _vars}


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
    """The module math, whose functions that make large numbers are guarded."""
    guarded = ModuleType("math")
    guarded.__dict__.update(vars(math))
    for name in ("factorial", "comb", "perm"):
        setattr(guarded, name, _few(getattr(math, name)))
    guarded.prod = _product  # type: ignore[attr-defined]
    return guarded


def tokenized(tokenize: Callable[..., list[str]]) -> Callable[..., list[str]]:
    """Xacro's tokenize, which builds a pattern of its separators: they may not close the set and go on."""

    def guarded(s: Any, sep: str = ",; ", skip_empty: Any = True) -> list[str]:  # noqa: FBT002 (xacro's signature)
        if "]" in sep or "\\" in sep:
            raise ForbiddenExpression("']' and '\\' are not allowed as separators")
        return tokenize(s, sep, skip_empty)

    return guarded
