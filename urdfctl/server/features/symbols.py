"""The outline of a file, and the values of its expressions beside them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.diagnostic import Location, located
from urdfctl.server.analysis.names import names_in
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.xacro_names import PARAMETER
from urdfctl.source.opaque import UNKNOWN
from urdfctl.startup.records import NamedTuple

_MOST_TEXT = 24
_LONG_NUMBER = r"(?<![\w.])\d+\.\d{5,}(?:e[+-]?\d+)?(?![\w.])"


class Symbol(NamedTuple):
    """Something that a file defines."""

    name: str
    kind: str
    at: Location


class Hint(NamedTuple):
    """The value of an expression, to be shown after it. line and column are those of its end, from 1."""

    line: int
    column: int
    value: str


def symbols_in(question: Question) -> list[Symbol]:
    """Return what a file defines, in order. What several robots call by different names has the name that it is
    written with."""
    found: dict[Location, Symbol] = {}
    for robot in question.robots:
        for name in names_in(robot):
            if name.defines and name.span.file == question.file and name.kind != PARAMETER:
                at = located(name.span)
                found.setdefault(at, Symbol(name.span.text if name.is_computed else name.text, name.kind, at))
    return sorted(found.values(), key=lambda symbol: symbol.at)


def hints_in(question: Question) -> list[Hint]:
    """Return the values of the attributes with expressions, where all calls and robots agree on them.

    Numbers are rounded to four digits.
    """
    values: dict[tuple[int, int], set[str]] = {}
    for line, column, value in _values(question):
        values.setdefault((line, column), set()).add(value)
    agreed = ((place, next(iter(found))) for place, found in sorted(values.items()) if len(found) == 1)
    return [Hint(line, column, value) for (line, column), value in agreed if UNKNOWN not in value]


def _values(question: Question) -> Iterator[tuple[int, int, str]]:
    for evaluated in question.evaluated():
        value = re.sub(_LONG_NUMBER, lambda found: f"{float(found[0]):.4g}", evaluated.value)
        if len(value) <= _MOST_TEXT:
            position = question.source.position(evaluated.span.end)
            yield position.line, position.column, value
