"""What Python's operators and methods make of terms; whatever is not sure to be harmless gives what cannot be told."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Mapping, Sequence

from urdfctl.source.launch.terms import (
    MOST_CHARACTERS,
    MOST_ITEMS,
    Called,
    Constant,
    Items,
    Missing,
    OneOf,
    Perhaps,
    Table,
    Term,
    is_same,
    known_text,
    one_of,
)
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

_WITHOUT_ARGUMENTS = frozenset("lower upper strip lstrip rstrip title capitalize as_posix absolute resolve".split())
_TESTS = frozenset("startswith endswith".split())
_PATTERN = r"%[sd]|%%"
_FIELD = r"\{\{|\}\}|\{([^{}]*)\}"


def text_at(text: str, at: Place) -> Term:
    """A text, unless it grew beyond any that a launch file has."""
    return Constant(text, at) if len(text) <= MOST_CHARACTERS else Missing(at)


def shown(term: Term) -> str:
    """What `str()` gives for a term; UNKNOWN where that cannot be told."""
    if isinstance(term, Constant):
        return str(term.value)
    return UNKNOWN


def truth(term: Term) -> bool | None:
    """Whether Python takes a term for true; None where that cannot be told."""
    if isinstance(term, Constant):
        return None if isinstance(term.value, str) and UNKNOWN in term.value else bool(term.value)
    if isinstance(term, Items):
        return None if term.values and all(isinstance(v, Perhaps) for v in term.values) else bool(term.values)
    if isinstance(term, Table):
        return bool(term.entries) or (False if term.whole else None)
    return None


def added(left: Term, right: Term, at: Place) -> Term:
    """`left + right`: texts, numbers and lists; an unknown piece of a text stays one."""
    if isinstance(left, Items) and isinstance(right, Items):
        return Items([*left.values, *right.values][:MOST_ITEMS], at)
    if isinstance(left, Items) or isinstance(right, Items):
        known = [one for one in (left, right) if isinstance(one, Items)]
        return Items([*known[0].values, Perhaps(Missing(at), at)], at)
    if isinstance(left, Constant) and isinstance(right, Constant):
        if isinstance(left.value, (int, float)) and isinstance(right.value, (int, float)):
            return Constant(left.value + right.value, at)
        if isinstance(left.value, str) and isinstance(right.value, str):
            return text_at(left.value + right.value, at)
        return Missing(at)
    if any(isinstance(one, Constant) and isinstance(one.value, str) for one in (left, right)):
        if isinstance(left, Called) or isinstance(right, Called):
            return Items([left, right], at)  # newer distros: a substitution and a text
        return text_at(shown(left) + shown(right), at)
    return Missing(at)


def binary(operator: ast.operator, left: Term, right: Term, at: Place) -> Term:
    """What an operator gives."""
    if isinstance(operator, ast.Add):
        return added(left, right, at)
    if isinstance(operator, ast.BitOr) and isinstance(left, Table) and isinstance(right, Table):
        both = Table(at)
        both.take(left)
        both.take(right)
        return both
    if isinstance(operator, ast.Div):
        return _below(left, right, at)
    if isinstance(operator, ast.Mod) and isinstance(left, Constant) and isinstance(left.value, str):
        values = right.values if isinstance(right, Items) else [right]
        return _filled(left.value, values, at)
    return Missing(at)


def _below(left: Term, right: Term, at: Place) -> Term:
    """A path below another: of a folder's text, or of a substitution."""
    if isinstance(left, Constant) and isinstance(left.value, str):
        return text_at(os.path.join(left.value, shown(right)), at)
    if isinstance(left, Called):
        return Called("PathJoinSubstitution", at, [Items([left, right], at)])
    return Missing(at)


def _filled(pattern: str, values: Sequence[Term], at: Place) -> Term:
    """`'%s' % values`."""
    rest = iter(values)

    def value(match: re.Match[str]) -> str:
        return "%" if match.group() == "%%" else shown(next(rest, Missing(at)))

    return text_at(re.sub(_PATTERN, value, pattern), at)


def compared(operator: ast.cmpop, left: Term, right: Term, at: Place) -> Term:
    """`==`, `!=`, `is`, `is not`, `in` and `not in`; no other comparison is worked out."""
    if isinstance(operator, (ast.Eq, ast.Is, ast.NotEq, ast.IsNot)):
        equal = _equal(left, right)
        wanted = isinstance(operator, (ast.Eq, ast.Is))
        return Missing(at) if equal is None else Constant(equal is wanted, at)
    if isinstance(operator, (ast.In, ast.NotIn)):
        held = _holds(right, left)
        return Missing(at) if held is None else Constant(held is isinstance(operator, ast.In), at)
    return Missing(at)


def _equal(left: Term, right: Term) -> bool | None:
    if isinstance(left, Constant) and isinstance(right, Constant):
        unknown = UNKNOWN in shown(left) or UNKNOWN in shown(right)
        return None if unknown else left.value == right.value
    if any(isinstance(one, Constant) and one.value is None for one in (left, right)):
        return None if any(isinstance(one, (Missing, OneOf)) for one in (left, right)) else False
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
    """`of[key]`."""
    if isinstance(of, Table) and isinstance(key, Constant) and isinstance(key.value, str):
        return of.entries.get(key.value) or Missing(at)
    if isinstance(of, Items) and isinstance(key, Constant) and isinstance(key.value, int):
        certain = not any(isinstance(value, Perhaps) for value in of.values)
        return of.values[key.value] if certain and -len(of.values) <= key.value < len(of.values) else Missing(at)
    return Missing(at)


def method(of: Term, name: str, arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place) -> Term | None:
    """What a method of a text or dict gives; None where it is neither."""
    if isinstance(of, Constant) and isinstance(of.value, str):
        return _of_text(of.value, name, arguments, keywords, at)
    if isinstance(of, Table):
        return _of_table(of, name, arguments, at)
    if isinstance(of, OneOf) and len(of.options) * len(arguments) < MOST_ITEMS:
        found = [method(option, name, arguments, keywords, at) for option in of.options]
        return one_of([one for one in found if one], at) if all(found) else Missing(at)
    return None


def _of_text(  # noqa: PLR0911 (one for each method)
    text: str, name: str, arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place
) -> Term:
    if name == "format":
        return _formatted(text, arguments, keywords, at)
    if name == "joinpath":
        return text_at(os.path.join(text, *map(shown, arguments)), at)
    if name == "join" and arguments and isinstance(arguments[0], Items):
        return text_at(text.join(map(shown, arguments[0].values)), at)
    if name in {"read_text", "open"}:
        called = Called("read", at)
        called.of = Called("open", at, [Constant(text, at)])
        return called
    if UNKNOWN in text:
        return Constant(UNKNOWN, at)
    given = [known_text(argument) for argument in arguments]
    known = [one for one in given if one is not None]
    if len(known) != len(given):
        return Missing(at)
    if name in _WITHOUT_ARGUMENTS and not known:
        changed = text if name in {"as_posix", "absolute", "resolve"} else getattr(str, name)(text)
        return text_at(changed, at)
    if name in _TESTS and len(known) == 1:
        return Constant(getattr(text, name)(known[0]), at)
    if name == "replace" and len(known) == 2 and len(text) * (len(known[1]) + 1) <= MOST_CHARACTERS:  # noqa: PLR2004
        return text_at(text.replace(known[0], known[1]), at)
    if name == "split" and len(known) <= 1 and known != [""]:
        return Items([Constant(part, at) for part in text.split(known[0] if known else None)][:MOST_ITEMS], at)
    return Missing(at)


def _formatted(text: str, arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place) -> Term:
    rest = iter(arguments)

    def value(match: re.Match[str]) -> str:
        field = match.group(1)
        if field is None:
            return match.group()[0]
        field = field.removesuffix("!s")
        if not field:
            return shown(next(rest, Missing(at)))
        if re.fullmatch(r"\d{1,3}", field):
            return shown(arguments[int(field)]) if int(field) < len(arguments) else UNKNOWN
        return shown(keywords.get(field) or Missing(at))

    return text_at(re.sub(_FIELD, value, text), at)


def _of_table(table: Table, name: str, arguments: Sequence[Term], at: Place) -> Term | None:
    keys = [Constant(key, table.keys[key]) for key in table.entries]
    rest = [] if table.whole else [Perhaps(Missing(at), at)]
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
            return Missing(at)
        return table.entries.get(key) or (arguments[1] if len(arguments) > 1 else Constant(None, at))
    return Missing(at)
