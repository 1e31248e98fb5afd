"""Helpers for the rules of this family. Each rule turns the problems of one kind into findings."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Note, Project, Severity
from urdfctl.source.problem import Problem, ProblemKind


def findings_of(project: Project, kind: ProblemKind) -> Iterator[Finding]:
    """Yield a finding for each problem of a kind that occurred while the files were read.

    A problem that depends on a guess is a warning.
    """
    for problem in project.of_kind(kind):
        fix = Fix(problem.hint) if problem.hint else None
        severity = Severity.WARNING if problem.guessed else None
        used = (Note("used here", problem.used),) if problem.used else ()
        yield Finding(problem.at, problem.message, (*used, *consequences_of(problem)), fix, severity)


def consequences_of(problem: Problem) -> tuple[Note, ...]:
    """Return a note with the number of problems that follow from this one and are not told."""
    if not problem.follows:
        return ()
    return (Note("1 more error follows" if problem.follows == 1 else f"{problem.follows} more errors follow"),)
