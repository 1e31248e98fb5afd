"""Evaluate the `$(eval ...)` of roslaunch without running it."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

from urdfctl.source.launch.python import evaluated as of_python
from urdfctl.source.launch.terms import Constant, Context, Function, Plain, Term, known_text
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place, SourceText
from urdfctl.source.variables import required

_AT = Place(SourceText("", b""), 0, end=0)
_TRUTH = {"true": True, "false": False}


def evaluated(
    expression: str,
    arguments: Mapping[str, str],
    environ: Mapping[str, str],
    find: Callable[[str], str | None],
    folder: str,
    too_long: Callable[[], None] = lambda: None,
) -> str:
    """Return the text of an expression; UNKNOWN if it is unknown.

    arguments: the launch arguments by name. Like roslaunch, numbers and booleans among them are converted.
    environ: the environment variables.
    find: returns the folder of a package; None if unknown.
    folder: the folder of the launch file.
    too_long: called if the text would be too long.
    """

    def argument(name: str, _: str | None) -> Term:
        return _converted(arguments.get(name, UNKNOWN))

    def variable(name: str, default: str | None) -> Term:
        return _text(required(environ, name) if default is None else environ.get(name, default))

    used = set(re.findall(r"\w+", expression))
    names: dict[str, Term] = {name: _converted(arguments[name]) for name in used if name in arguments}
    names["arg"] = _function("arg", argument)
    names["env"] = _function("env", lambda name, _: variable(name, None))
    names["optenv"] = _function("optenv", lambda name, default: variable(name, default or ""))
    names["find"] = _function("find", lambda name, _: _text(find(name) or UNKNOWN))
    names["dirname"] = _function("dirname", lambda *_: _text(folder), without=True)
    return of_python(expression, names, too_long)


def _function(name: str, result: Callable[[str, str | None], Term], *, without: bool = False) -> Function:
    """A function of a text and an optional second one, or `without` arguments."""

    def call(arguments: Sequence[Term], keywords: Mapping[str, Term], _: Context | None) -> Term:  # noqa: ARG001
        texts = [known_text(given) for given in arguments]
        if (not texts and not without) or None in texts:
            return _text(UNKNOWN)
        first, second = (*texts, None, None)[:2]
        return result(first or "", second)

    return Function(name, call, _AT)


def _text(text: str) -> Term:
    return Constant(text, _AT)


def _converted(text: str) -> Term:
    """A launch argument as roslaunch converts it for an expression: a number, a bool or a text."""
    value: Plain = text
    try:
        value = float(text) if "." in text else int(text)
    except ValueError:
        value = _TRUTH.get(text.lower(), text)
    return Constant(value, _AT)
