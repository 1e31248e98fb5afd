"""Python's operators and methods on terms. Operations that are not known to be safe give an unknown term."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from operator import floordiv, mod, mul, sub, truediv

from urdfctl.source.launch.terms import (
    MOST_ITEMS,
    Called,
    Constant,
    Items,
    OneOf,
    Perhaps,
    Table,
    Term,
    UnknownTerm,
    is_same,
    known_text,
    one_of,
)
from urdfctl.source.lengths import MOST_CHARACTERS, Room, until_too_long
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

_WITHOUT_ARGUMENTS = frozenset("lower upper strip lstrip rstrip title capitalize as_posix absolute resolve".split())
_TESTS = frozenset("startswith endswith".split())
_DEEPEST = 4
_LARGEST = 1e9
_ARITHMETIC: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Sub: sub,
    ast.Mult: mul,
    ast.Div: truediv,
    ast.FloorDiv: floordiv,
    ast.Mod: mod,
}
_PATTERN = r"%[sd]|%%"
_FIELD = r"\{\{|\}\}|\{([^{}]*)\}"


def text_at(text: str, at: Place) -> Term:
    """Return a text as a term; unknown if it is longer than any text in a real launch file."""
    return Constant(text, at) if len(text) <= MOST_CHARACTERS else UnknownTerm(at, too_long=True)


def joined_at(separator: str, parts: Iterable[str], at: Place) -> Term:
    """Return texts with a separator between them as one term, as `text_at` does."""
    return text_at(separator.join(until_too_long(parts)), at)


def _replaced_at(pattern: str, value: Callable[[re.Match[str]], str], text: str, at: Place) -> Term:
    """A text with values in the place of what a pattern matches, as `text_at` returns it."""
    room = Room()
    replaced = re.sub(pattern, lambda match: room.take(value(match)), text)
    return UnknownTerm(at, too_long=True) if room.is_over else text_at(replaced, at)


def listed(term: Term) -> list[Term] | None:
    """Return the items that a loop over a term visits; None if unknown."""
    if isinstance(term, Items):
        return list(term.values)
    if isinstance(term, Table):
        keys: list[Term] = [Constant(key, term.keys[key]) for key in term.entries]
        return keys if term.whole else [*keys, Perhaps(UnknownTerm(term.at), term.at)]
    return None


def shown(term: Term) -> str:
    """Return `str()` of a term; UNKNOWN if it is unknown."""
    if isinstance(term, Constant):
        return str(term.value)
    if isinstance(term, (Items, Table)):
        text = "".join(until_too_long(_written(term)))
        return text if UNKNOWN not in text and len(text) <= MOST_CHARACTERS else UNKNOWN
    return UNKNOWN


def _written(term: Term, depth: int = 0) -> Iterator[str]:
    """The parts of `repr()` of a term; one of them is UNKNOWN if it is unknown."""
    if isinstance(term, Constant):
        yield repr(term.value)
    elif depth <= _DEEPEST and isinstance(term, Items):
        yield "["
        for index, value in enumerate(term.values):
            yield ", " if index else ""
            yield from _written(value, depth + 1)
        yield "]"
    elif depth <= _DEEPEST and isinstance(term, Table) and term.whole:
        yield "{"
        for index, (key, value) in enumerate(term.entries.items()):
            yield f"{', ' if index else ''}{key!r}: "
            yield from _written(value, depth + 1)
        yield "}"
    else:
        yield UNKNOWN


def truth(term: Term) -> bool | None:
    """Return `bool()` of a term; None if it is unknown."""
    if isinstance(term, Constant):
        return None if isinstance(term.value, str) and UNKNOWN in term.value else bool(term.value)
    if isinstance(term, Items):
        return None if term.values and all(isinstance(v, Perhaps) for v in term.values) else bool(term.values)
    if isinstance(term, Table):
        return bool(term.entries) or (False if term.whole else None)
    return True if _is_setting(term) else None


def _is_setting(term: Term) -> bool:
    """Whether a term is a substitution for a launch argument, which is an object whatever the argument's value is.

    ros2/launch, substitution.py: `Substitution` has neither `__eq__` nor `__bool__`.
    """
    return isinstance(term, Called) and term.of is None and term.short == "LaunchConfiguration"


def added(left: Term, right: Term, at: Place) -> Term:
    """Return `left + right` for texts, numbers and lists. An unknown operand gives a text that is partly unknown."""
    if isinstance(left, Items) and isinstance(right, Items):
        return Items([*left.values, *right.values][:MOST_ITEMS], at)
    if isinstance(left, Items) or isinstance(right, Items):
        known = [operand for operand in (left, right) if isinstance(operand, Items)]
        return Items([*known[0].values, Perhaps(UnknownTerm(at), at)], at)
    if isinstance(left, Constant) and isinstance(right, Constant):
        if isinstance(left.value, (int, float)) and isinstance(right.value, (int, float)):
            return Constant(left.value + right.value, at)
        if isinstance(left.value, str) and isinstance(right.value, str):
            return text_at(left.value + right.value, at)
        return UnknownTerm(at)
    if any(isinstance(operand, Constant) and isinstance(operand.value, str) for operand in (left, right)):
        if isinstance(left, Called) or isinstance(right, Called):
            return Items([left, right], at)  # newer distros: a substitution and a text
        return text_at(shown(left) + shown(right), at)
    return UnknownTerm(at)


def binary(operator: ast.operator, left: Term, right: Term, at: Place) -> Term:
    """Return the result of a binary operator."""
    if isinstance(operator, ast.Add):
        return added(left, right, at)
    if isinstance(operator, ast.BitOr) and isinstance(left, Table) and isinstance(right, Table):
        both = Table(at)
        both.take(left)
        both.take(right)
        return both
    if type(operator) in _ARITHMETIC and isinstance(left, Constant) and isinstance(left.value, (int, float)):
        return _reckoned(_ARITHMETIC[type(operator)], left.value, right, at)
    if isinstance(operator, ast.Div):
        return _below(left, right, at)
    if isinstance(operator, ast.Mod) and isinstance(left, Constant) and isinstance(left.value, str):
        values = right.values if isinstance(right, Items) else [right]
        return _filled(left.value, values, at)
    return UnknownTerm(at)


def _reckoned(function: Callable[[float, float], float], left: float, right: Term, at: Place) -> Term:
    """The result of an operator on two numbers, as far as it is not too large."""
    other = right.value if isinstance(right, Constant) else None
    if not isinstance(other, (int, float)) or max(abs(left), abs(other)) > _LARGEST:
        return UnknownTerm(at)
    try:
        return Constant(function(left, other), at)
    except ZeroDivisionError:
        return UnknownTerm(at)


def _below(left: Term, right: Term, at: Place) -> Term:
    """The result of `left / right`, where `left` is a path or a substitution."""
    if isinstance(left, Constant) and isinstance(left.value, str):
        return text_at(os.path.join(left.value, shown(right)), at)
    if isinstance(left, Called):
        return Called("PathJoinSubstitution", at, [Items([left, right], at)])
    return UnknownTerm(at)


def _filled(pattern: str, values: Sequence[Term], at: Place) -> Term:
    """The result of `pattern % values`."""
    rest = iter(values)

    def value(match: re.Match[str]) -> str:
        return "%" if match.group() == "%%" else shown(next(rest, UnknownTerm(at)))

    return _replaced_at(_PATTERN, value, pattern, at)


def compared(operator: ast.cmpop, left: Term, right: Term, at: Place) -> Term:
    """Return the result of a comparison."""
    if isinstance(operator, (ast.Eq, ast.Is, ast.NotEq, ast.IsNot)):
        equal = _equal(left, right)
        wanted = isinstance(operator, (ast.Eq, ast.Is))
        return UnknownTerm(at) if equal is None else Constant(equal is wanted, at)
    if isinstance(operator, (ast.In, ast.NotIn)):
        held = _holds(right, left)
        return UnknownTerm(at) if held is None else Constant(held is isinstance(operator, ast.In), at)
    lesser = isinstance(operator, (ast.Lt, ast.LtE))
    first, second = (left, right) if lesser else (right, left)
    below = _is_below(first, second, equal=isinstance(operator, (ast.LtE, ast.GtE)))
    return UnknownTerm(at) if below is None else Constant(below, at)


def _is_below(left: Term, right: Term, *, equal: bool) -> bool | None:
    """Whether a number is less than another one, or equal to it; None if they are not known numbers."""
    if isinstance(left, Constant) and isinstance(right, Constant):
        first, second = left.value, right.value
        if isinstance(first, (int, float)) and isinstance(second, (int, float)):
            return first < second or (equal and first == second)
    return None


def _equal(left: Term, right: Term) -> bool | None:
    if isinstance(left, Constant) and isinstance(right, Constant):
        unknown = UNKNOWN in shown(left) or UNKNOWN in shown(right)
        return None if unknown else left.value == right.value
    if any(map(_is_setting, (left, right))) and any(isinstance(each, Constant) for each in (left, right)):
        return False
    if any(isinstance(operand, Constant) and operand.value is None for operand in (left, right)):
        return None if any(isinstance(operand, (UnknownTerm, OneOf)) for operand in (left, right)) else False
    return None


def _holds(container: Term, item: Term) -> bool | None:
    wanted = known_text(item)
    if wanted is None:
        return None
    if isinstance(container, Table):
        return True if wanted in container.entries else False if container.whole else None
    if isinstance(container, Items):
        if any(is_same(value, item) for value in container.values):
            return True
        return False if all(isinstance(value, Constant) for value in container.values) else None
    text = known_text(container)
    return None if text is None else wanted in text


def item_of(of: Term, key: Term, at: Place) -> Term:
    """Return `of[key]`."""
    if isinstance(of, Table) and isinstance(key, Constant) and isinstance(key.value, str):
        return of.entries.get(key.value) or UnknownTerm(at)
    if isinstance(of, Items) and isinstance(key, Constant) and isinstance(key.value, int):
        certain = not any(isinstance(value, Perhaps) for value in of.values)
        return of.values[key.value] if certain and -len(of.values) <= key.value < len(of.values) else UnknownTerm(at)
    return UnknownTerm(at)


def slice_of(of: Term, start: Term | None, end: Term | None, at: Place) -> Term:
    """Return `of[start:end]` of a text or a list without optional items."""
    given = [part.value if isinstance(part, Constant) else part for part in (start, end)]
    bounds = [bound if isinstance(bound, int) else None for bound in given]
    if bounds != given:
        return UnknownTerm(at)
    whole = slice(*bounds)
    if isinstance(of, Items) and not any(isinstance(value, Perhaps) for value in of.values):
        return Items(of.values[whole], at)
    text = known_text(of)
    return UnknownTerm(at) if text is None else Constant(text[whole], at)


def method(of: Term, name: str, arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place) -> Term | None:
    """Return the result of a method of a text or a dict; None if the term is neither."""
    if isinstance(of, Constant) and isinstance(of.value, str):
        return _of_text(of.value, name, arguments, keywords, at)
    if isinstance(of, Table):
        return _of_table(of, name, arguments, at)
    if isinstance(of, OneOf) and len(of.options) * len(arguments) < MOST_ITEMS:
        results = [method(option, name, arguments, keywords, at) for option in of.options]
        return one_of([result for result in results if result], at) if all(results) else UnknownTerm(at)
    return None


def _of_text(  # noqa: PLR0911 (one return per method)
    text: str, name: str, arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place
) -> Term:
    if name == "format":
        return _formatted(text, arguments, keywords, at)
    if name == "joinpath":
        return text_at(os.path.join(text, *until_too_long(map(shown, arguments))), at)
    if name == "join" and arguments and isinstance(arguments[0], Items):
        length = len(text) * len(arguments[0].values)
        return (
            UnknownTerm(at, too_long=True)
            if length > MOST_CHARACTERS
            else joined_at(text, map(shown, arguments[0].values), at)
        )
    if name in {"read_text", "open"}:
        called = Called("read", at)
        called.of = Called("open", at, [Constant(text, at)])
        return called
    if UNKNOWN in text:
        return Constant(UNKNOWN, at)
    given = [known_text(argument) for argument in arguments]
    known = [argument for argument in given if argument is not None]
    if len(known) != len(given):
        return UnknownTerm(at)
    if name in _WITHOUT_ARGUMENTS and not known:
        changed = text if name in {"as_posix", "absolute", "resolve"} else getattr(str, name)(text)
        return text_at(changed, at)
    if name in _TESTS and len(known) == 1:
        return Constant(getattr(text, name)(known[0]), at)
    if name == "replace" and len(known) == 2 and len(text) * (len(known[1]) + 1) <= MOST_CHARACTERS:  # noqa: PLR2004
        return text_at(text.replace(known[0], known[1]), at)
    if name == "split" and len(known) <= 1 and known != [""]:
        return Items([Constant(part, at) for part in text.split(known[0] if known else None)][:MOST_ITEMS], at)
    return UnknownTerm(at)


def _formatted(text: str, arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place) -> Term:
    rest = iter(arguments)

    def value(match: re.Match[str]) -> str:
        field = match.group(1)
        if field is None:
            return match.group()[0]
        field = field.removesuffix("!s")
        if not field:
            return shown(next(rest, UnknownTerm(at)))
        if re.fullmatch(r"\d{1,3}", field):
            return shown(arguments[int(field)]) if int(field) < len(arguments) else UNKNOWN
        return shown(keywords.get(field) or UnknownTerm(at))

    return _replaced_at(_FIELD, value, text, at)


def _of_table(table: Table, name: str, arguments: Sequence[Term], at: Place) -> Term | None:
    keys = [Constant(key, table.keys[key]) for key in table.entries]
    rest = [] if table.whole else [Perhaps(UnknownTerm(at), at)]
    if name == "items":
        pairs = [Items([key, table.entries[str(key.value)]], key.at) for key in keys]
        return Items([*pairs, *rest], at)
    if name == "keys":
        return Items([*keys, *rest], at)
    if name == "values":
        return Items([*table.entries.values(), *rest], at)
    if name == "copy":
        copied = Table(at)
        copied.take(table)
        return copied
    if name == "update":
        given = arguments[0] if arguments else None
        if isinstance(given, Table):
            table.take(given)
        else:
            table.whole = False
        return Constant(None, at)
    if name == "get" and arguments:
        key = known_text(arguments[0])
        if key is None or (key not in table.entries and not table.whole):
            return UnknownTerm(at)
        return table.entries.get(key) or (arguments[1] if len(arguments) > 1 else Constant(None, at))
    return UnknownTerm(at)
