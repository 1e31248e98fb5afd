"""What is shown about a name of xacro: the value of a property, the default of an argument, a macro's parameters."""

from __future__ import annotations

import math
from collections.abc import Iterator

from urdfctl.server.analysis.names import NamePlace
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.scopes import Defined, Scopes, macro_around
from urdfctl.server.analysis.xacro_names import ARGUMENT, MACRO, PARAMETER, PROPERTY

CONSTANTS = {"pi": math.pi, "e": math.e, "tau": math.tau}
"""Numbers that expressions of xacro know by name."""
_MOST_VALUES = 4


def is_builtin(name: NamePlace, scopes: Scopes) -> bool:
    """Return whether a name in an expression is a constant that xacro brings, not a property of these files."""
    return name.kind == PROPERTY and name.text in CONSTANTS and not any(_same(scopes, name))


def described_name(question: Question, name: NamePlace) -> Iterator[str]:
    """Yield what is known about a macro, parameter, property or argument, as Markdown; nothing about other names."""
    if name.kind not in {ARGUMENT, MACRO, PARAMETER, PROPERTY}:
        return
    scopes = Scopes(source for source in question.sources() if source.is_xacro)
    if is_builtin(name, scopes):
        yield f"a constant of xacro: `{CONSTANTS[name.text]}`"
    elif name.kind == MACRO:
        shown = ", ".join(_shown_parameter(one) for one in scopes.parameters(name.text).values())
        yield f"parameters: {shown}" if shown else "no parameters"
    elif name.kind == PARAMETER:
        known = scopes.parameters(name.scope).get(name.text)
        if known is not None:
            yield _default(known)
    else:
        here = macro_around(name.span.source.data, name.span.start)
        everywhere = list(_same(scopes, name))
        local = [one for one in everywhere if here and (one.macro, one.file) == (here, name.span.file)]
        defined = local or everywhere
        yield from _values(defined) if name.kind == PROPERTY else map(_default, defined[:1])
        if name.kind == ARGUMENT:
            yield from _given(question, name.text)


def _same(scopes: Scopes, name: NamePlace) -> Iterator[Defined]:
    return (one for one in scopes.of(name.kind) if one.name == name.text)


def _shown_parameter(one: Defined) -> str:
    stars = "*" if one.is_block else ""
    return f"`{stars}{one.name}`" if one.value is None else f"`{stars}{one.name}:={one.value}`"


def _default(one: Defined) -> str:
    if one.is_block:
        return "takes elements"
    return "no default: it must be given" if one.value is None else f"default: `{one.value}`"


def _values(defined: list[Defined]) -> Iterator[str]:
    """The values of a property as they are written; of several definitions, the last one that was read counts."""
    values = list(dict.fromkeys(one.value for one in defined if one.value is not None))
    shown = [f"`{value}`" for value in values[:_MOST_VALUES]]
    if shown:
        more = f" and {len(values) - _MOST_VALUES} more" if len(values) > _MOST_VALUES else ""
        yield f"written as {', '.join(shown)}{more}"


def _given(question: Question, argument: str) -> Iterator[str]:
    """The values that launch files and variants give an argument."""
    given = dict.fromkeys(dict(robot.arguments).get(argument) for robot in question.shown)
    shown = [f"`{value}`" for value in given if value is not None]
    if shown:
        yield f"given: {', '.join(shown[:_MOST_VALUES])}"
