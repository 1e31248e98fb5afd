"""What the rules of this family share: each turns the problems of one kind into findings."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project
from urdfctl.source.problem import ProblemKind


def findings_of(project: Project, kind: ProblemKind) -> Iterator[Finding]:
    """One finding for each problem of a kind that reading met."""
    for problem in project.of_kind(kind):
        yield Finding(problem.at, problem.message, fix=Fix(problem.hint) if problem.hint else None)
