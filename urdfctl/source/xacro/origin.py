"""Where the text is written that xacro could not evaluate, and what was probably meant by an unknown name in it."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence

from urdfctl.names import is_only_slip, nearest
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import Place
from urdfctl.source.xml.dom import Element

_PARAMETER = r"(?:^|\s)([A-Za-z_]\w*)"
_OF_TEXTS = {ProblemKind.UNDEFINED_NAME, ProblemKind.UNDEFINED_ARGUMENT, ProblemKind.EXPRESSION}


def suggested(problem: Problem, known: Collection[str]) -> Problem:
    """Return a problem with the known name that was probably meant by an unknown one, if any is similar."""
    meant = nearest(problem.subject, known) if problem.subject and known else None
    if meant is None:
        return problem
    hint = f"write $(arg {meant})" if problem.kind is ProblemKind.UNDEFINED_ARGUMENT else f"write '{meant}'"
    correct = meant if is_only_slip(problem.subject, meant, known) else ""
    message = f"{problem.message}; did you mean '{meant}'?"
    return problem._replace(message=message, hint=hint, meant=meant, correct=correct)


def parameters_of(macro: Element | None) -> list[str]:
    """Return the names of a macro's parameters, without those of blocks."""
    return re.findall(_PARAMETER, macro.attrs.get("params", "")) if macro is not None else []


def parameters_around(at: Place, macros: Iterable[Element]) -> list[str]:
    """Return the parameters of the macros that a place is in."""
    around = (macro for macro in macros if macro.at.source is at.source and _is_within(at, macro.at))
    return [name for macro in around for name in parameters_of(macro)]


def _is_within(at: Place, element: Place) -> bool:
    return element.closing is not None and element.start <= at.start <= element.closing


def traced(problem: Problem, expression: str, properties: Sequence[Sequence[Element]]) -> Problem:
    """Return a problem at the property that contains the text, and not where the property is used.

    xacro evaluates a property where it is used.

    expression: what could not be evaluated.
    properties: the definitions of each property that was looked up for it, the innermost last.
    """
    wanted = "".join((problem.subject if problem.kind is ProblemKind.EXPRESSION else expression).split())
    if problem.kind not in _OF_TEXTS or not wanted:
        return problem
    for element in reversed(properties[-1] if properties else ()):
        for attribute in ("value", "default"):
            if wanted in "".join(element.attrs.get(attribute, "").split()):
                return problem._replace(at=element.at[attribute], used=problem.at)
    return problem
