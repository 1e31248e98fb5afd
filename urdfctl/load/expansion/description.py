"""Expand a description, or read it as it is if it is plain URDF."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from urdfctl.model.robot.build_robot import TOP_LEVEL
from urdfctl.source.disk.files import FileProblem
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xacro.expanded import HARMLESS, Expansion
from urdfctl.source.xacro.expansion import Expander
from urdfctl.source.xml.dom import Document
from urdfctl.source.xml.parsing import parse
from urdfctl.startup.records import NamedTuple

_EXPRESSION = rb"\$[({]"
MakeExpander = Callable[[type[Expander]], Expander]
"""Returns a new expander of a kind."""

_OF_INCLUDES = {
    ProblemKind.FILE_NOT_FOUND,
    ProblemKind.PACKAGE_NOT_FOUND,
    ProblemKind.PACKAGE_ABSENT,
    ProblemKind.FILE_UNREADABLE,
}


class ExpandedDescription(NamedTuple):
    """An expansion, and what expanded it."""

    expander: Expander
    expansion: Expansion


def expanded_by(expander: Expander, path: str, arguments: Mapping[str, str]) -> ExpandedDescription:
    """Return the expansion of a description by one expander."""
    return ExpandedDescription(expander, expansion_of(expander, path, arguments))


def expansion_of(expander: Expander, path: str, arguments: Mapping[str, str]) -> Expansion:
    """Return the expanded xacro file, or the tree of a plain URDF, which robots load as it is unless xacro is run."""
    try:
        source = expander.files.read(path)
    except FileProblem as error:
        return Expansion(None, [error.at(Place(SourceText(path, b""), 0, end=0))])
    if source.is_xacro or (expander.expands_all and re.search(_EXPRESSION, source.data)):
        return expander.expand(path, arguments)
    document, problems = _read(source, expander)
    return Expansion(document, problems, library=expander.is_library)


def _read(source: SourceText, expander: Expander) -> tuple[Document | None, list[Problem]]:
    """Read a plain URDF, with the one XML error that its readers accept: a late declaration."""
    try:
        return expander.parsed(source), expander.found.all
    except ReadError as error:
        problem = error.problem
    from urdfctl.source.xml.mistakes import LATE_DECLARATION

    if problem.subject != LATE_DECLARATION:
        return None, [problem]
    late = problem._replace(kind=ProblemKind.LATE_DECLARATION)
    try:
        return parse(source, expander.cloning, declarations=expander.trust, late_declaration=True), [late]
    except ReadError as error:
        return None, [error.problem]


def is_library(expansion: Expansion) -> bool:
    """Return whether a file expands to no part of a robot and has no error of its own: it only defines macros."""
    root = expansion.document.documentElement if expansion.document else None
    if root is None or any(child.tagName in TOP_LEVEL for child in root.elements()):
        return False
    return all(problem.kind in HARMLESS | _OF_INCLUDES for problem in expansion.problems)


def names_twice(expansion: Expansion) -> bool:
    """Return whether two links, or two joints, have the same known name."""
    root = expansion.document.documentElement if expansion.document else None
    named: set[tuple[str, str]] = set()
    for element in root.elements() if root is not None else ():
        key = element.tagName, element.attrs.get("name", "")
        if element.tagName in {"link", "joint"} and UNKNOWN not in key[1]:
            if key in named:
                return True
            named.add(key)
    return False
