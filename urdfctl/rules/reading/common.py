"""Helpers for the rules of this family. Each rule turns the problems of one kind into findings."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import SourceSpan

_ATTRIBUTE_NAME = rb"([\w:.-]+)\s*=\s*[\"']\Z"


def findings_of(project: Project, kind: ProblemKind) -> Iterator[Finding]:
    """Yield a finding for each problem of a kind that occurred while the files were read.

    A problem that depends on a guess is a warning; a file that the build makes is only worth knowing.
    """
    for problem in project.of_kind(kind):
        fix = _written_right(problem) if problem.meant else Fix(problem.hint) if problem.hint else None
        severity = Severity.INFO if problem.built else Severity.WARNING if problem.guessed else None
        used = (Note("used here", problem.used),) if problem.used else ()
        yield Finding(problem.at, problem.message, (*used, *consequences_of(problem)), fix, severity)


def _written_right(problem: Problem) -> Fix:
    """The fix that writes the name that is meant, wherever the text has the wrong one: safe if that is certain."""
    name = problem.subject.encode()
    start, end = _name_range(problem)
    pattern = rb"(?<![\w.'\"])" + re.escape(name) + rb"(?![\w'\"])"
    found = [match.start() for match in re.finditer(pattern, problem.at.source.data[start:end])]
    source = problem.at.source
    edits = (Edit(SourceSpan(source, start + at, start + at + len(name)), problem.meant) for at in found)
    return Fix(problem.hint, tuple(edits), safe=bool(found and problem.correct))


def _name_range(problem: Problem) -> tuple[int, int]:
    """From where to where the unknown name is written: before the value of an attribute, in a start tag, or in a
    text."""
    at = problem.at
    tag = at.source.start_tag(at.start)
    if problem.kind is ProblemKind.MACRO_CALL:
        written = re.search(_ATTRIBUTE_NAME, at.source.data[: at.start])
        return (written.start(1), written.end(1)) if written else (at.start, at.start)
    if problem.kind is ProblemKind.UNKNOWN_MACRO:
        if tag is None or not tag.self_closed:  # its end tag must be changed too
            return at.start, at.start
        first = at.start + len("<xacro:")
        return first, first + len(problem.subject.encode())
    return at.span.start, at.span.end


def consequences_of(problem: Problem) -> tuple[Note, ...]:
    """Return a note with the number of problems that follow from this one and are not told."""
    if not problem.follows:
        return ()
    return (Note("1 more error follows" if problem.follows == 1 else f"{problem.follows} more errors follow"),)
