"""Where the text is written that xacro could not evaluate, and what was probably meant by an unknown name in it."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from urdfctl.names import nearest
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.xml.dom import Element

_OF_TEXTS = {ProblemKind.UNDEFINED_NAME, ProblemKind.UNDEFINED_ARGUMENT, ProblemKind.EXPRESSION}


def suggested(problem: Problem, properties: Collection[str], arguments: Collection[str]) -> Problem:
    """Return a problem with the known name that was probably meant by an unknown one, if any is similar."""
    known = {ProblemKind.UNDEFINED_NAME: properties, ProblemKind.UNDEFINED_ARGUMENT: arguments}.get(problem.kind)
    meant = nearest(problem.subject, known) if known else None
    if meant is None:
        return problem
    hint = f"write $(arg {meant})" if problem.kind is ProblemKind.UNDEFINED_ARGUMENT else f"write '{meant}'"
    return problem._replace(message=f"{problem.message}; did you mean '{meant}'?", hint=hint)


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
