"""Findings that are warnings at most: what they are about is not started as it is linted, or hardly known."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Sequence

from urdfctl.diagnostic import Diagnostic, Remark, Severity
from urdfctl.lint.planning import PlannedTarget, TargetOrigin
from urdfctl.lint.results import Outcome, TargetResult
from urdfctl.load.target import Target

Pair = tuple[Target, TargetResult]
GUESSED = "the launch file needs arguments; their values are guessed from the files that exist"
UNSTARTED = "only without xacro arguments; every launch file that starts this robot gives it some"
ASIDE = "the folder '{}' is not what the repository starts"
UNUSED = "no robot uses this file"
OTHER_ROBOT = "only for a robot that no launch file starts; the file also serves one that is started"
LEFTOVER = "only where it is started with a launch file for ROS 1; its package is built for ROS 2"
_SAYS_SO = "UC639"
"""The code of the finding on a launch file that is left over."""
OF_PROSE = "only in the distro that the prose of a README names; set `distro` in urdfctl.toml if it is right"


def weakened(together: Outcome, apart: Iterable[Outcome], why: str, *, aside: bool = False) -> Outcome:
    """Return an outcome in which what its parts do not show apart is a warning at most, with a note that says why.

    aside: whether nothing starts it: then what would be a warning is only info.
    """
    known = {_key(diagnostic) for outcome in apart for diagnostic in outcome.diagnostics}
    return together._replace(
        diagnostics=[
            diagnostic if _key(diagnostic) in known else _weakened(diagnostic, why, aside=aside)
            for diagnostic in together.diagnostics
        ]
    )


def of_leftover(together: Outcome, alone: Outcome) -> Outcome:
    """Return the outcome of a launch file for ROS 1 that its package for ROS 2 has left: warnings at most.

    `ros2 launch` refuses the file, which one finding says. What only such a start shows is just worth knowing.

    alone: the outcome of the robot without its launch file.
    """
    known = {_key(diagnostic) for diagnostic in alone.diagnostics}
    return together._replace(diagnostics=[_of_leftover(each, known) for each in together.diagnostics])


def _of_leftover(diagnostic: Diagnostic, known: Collection[tuple[str, str, int, int]]) -> Diagnostic:
    if diagnostic.code == _SAYS_SO:
        return diagnostic
    weaker = _weakened(diagnostic, LEFTOVER, aside=False)
    return weaker if _key(diagnostic) in known else weaker._replace(severity=weaker.severity.milder)


def is_weakened(diagnostic: Diagnostic) -> bool:
    """Return whether `weakened` made a diagnostic less severe."""
    return any(note.message in (GUESSED, UNSTARTED, LEFTOVER, OF_PROSE) for note in diagnostic.notes)


def _weakened(diagnostic: Diagnostic, why: str, *, aside: bool) -> Diagnostic:
    severity = diagnostic.severity
    if aside or severity is Severity.ERROR:
        severity = severity.milder
    return diagnostic._replace(severity=severity, notes=(*diagnostic.notes, Remark(why)))


def _key(diagnostic: Diagnostic) -> tuple[str, str, int, int]:
    return diagnostic.code, diagnostic.at.file, diagnostic.at.start, diagnostic.at.end


def as_started(entry: PlannedTarget, result: TargetResult, launched: Iterable[TargetResult]) -> TargetResult:
    """Return the result of a description without its own findings if nobody starts it like that.

    This is so for a description in a folder that is linted with the defaults of its arguments, if all launch files that
    start it give it arguments. What is found there too stays. If a start is not wholly known, its own findings stay as
    warnings at most.
    """
    starts = [each for each in launched if each.path == result.path] if is_with_defaults(entry) else []
    if not starts or not all(each.arguments for each in starts):
        return result
    outcomes = [each.outcome for each in starts]
    if not all(each.complete and each.links for each in starts):
        return result._replace(outcome=weakened(result.outcome, outcomes, UNSTARTED))
    known = {_key(diagnostic) for outcome in outcomes for diagnostic in outcome.diagnostics}
    found = [diagnostic for diagnostic in result.outcome.diagnostics if _key(diagnostic) in known]
    return result._replace(outcome=result.outcome._replace(diagnostics=found))


def is_with_defaults(entry: PlannedTarget) -> bool:
    """Return whether a description of a folder is taken as it is: with its defaults, and without a launch file."""
    target = entry.target
    settings: Sequence[object] = (target.arguments, target.controllers, target.launch)
    return entry.origin in (TargetOrigin.FOUND, TargetOrigin.DECLARED) and not any(settings)


_ASIDE = frozenset(
    "test tests testing third_party thirdparty 3rdparty external extern vendor vendored deprecated obsolete archive "
    "backup backups templates attic to-be-deleted to_be_deleted".split()
)


_ASIDE_BY_LAST_WORD = r".*[^a-z](?:backups?|templates)"
"""`urdf_backup`, `package-templates`; `templates` alone, too. Not `template`, which whole packages are named after."""


def folder_aside(path: str) -> str | None:
    """Return the folder of tests, copies of others, backups or templates that a file is in, below the current one."""
    parts = os.path.relpath(path).split(os.sep)[:-1]
    return next((part for part in parts if _is_aside(part.lower())), None)


def _is_aside(name: str) -> bool:
    return name in _ASIDE or re.fullmatch(_ASIDE_BY_LAST_WORD, name) is not None


def as_used(pairs: Iterable[Pair], named: Collection[str], started: Iterable[TargetResult]) -> list[Pair]:
    """Return targets in which the findings of what is not started are less severe.

    What lies in folders of tests and copies is less severe by one step. What holds in a file of a started robot only
    for one that nothing starts is a warning at most.

    named: the paths that the user names: what is found there keeps its severity.
    started: the results of all launch files.
    """
    pairs = list(pairs)
    shared: dict[str, list[Outcome]] = {}
    for result in (*started, *(result for _, result in pairs)):
        for file in result.files if result.launch else ():
            shared.setdefault(file, []).append(result.outcome)
    return [
        (target, result if result.path in named or result.launch in named else _as_used(result, shared))
        for target, result in pairs
    ]


def _as_used(result: TargetResult, shared: dict[str, list[Outcome]]) -> TargetResult:
    outcome = result.outcome
    folder = folder_aside(result.launch or result.path)
    if folder is not None:
        outcome = weakened(outcome, [], ASIDE.format(folder), aside=True)
    elif result.launch is None and outcome.has_errors:
        started = {id(one): one for finding in outcome.diagnostics for one in shared.get(finding.at.file, ())}
        others = [finding for finding in outcome.diagnostics if finding.at.file not in shared]
        outcome = weakened(outcome, [*started.values(), Outcome(others, [])], OTHER_ROBOT)
    return result._replace(outcome=outcome)


def as_unused(pairs: Iterable[Pair], included: Collection[str]) -> list[Pair]:
    """Return targets that no robot uses, with findings that are less severe by one step.

    included: the files that a robot includes with other arguments: what is found there is a warning at most.
    """
    return [(target, _as_unused(result, aside=result.path not in included)) for target, result in pairs]


def _as_unused(result: TargetResult, *, aside: bool) -> TargetResult:
    return result._replace(outcome=weakened(result.outcome, [], UNUSED, aside=aside))
