"""Descriptions as no launch file starts them: without the arguments that all of these give."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from urdfctl.lint.elimination import UNSTARTED, weakened
from urdfctl.lint.planning import Origin, PlannedTarget
from urdfctl.lint.results import TargetResult


def as_started(entry: PlannedTarget, result: TargetResult, launched: Iterable[TargetResult]) -> TargetResult:
    """Return the result of a description; its own findings are warnings at most if nobody starts it like that.

    This is so for a description in a folder that is linted with the defaults of its arguments, if all launch files that
    start it give it arguments. What is found there too keeps its severity.
    """
    starts = [each for each in launched if each.path == result.path] if _is_with_defaults(entry) else []
    if not starts or not all(each.arguments for each in starts):
        return result
    return result._replace(outcome=weakened(result.outcome, [each.outcome for each in starts], UNSTARTED))


def _is_with_defaults(entry: PlannedTarget) -> bool:
    target = entry.target
    settings: Sequence[object] = (target.arguments, target.controllers, target.launch)
    return entry.origin is Origin.FOUND and not any(settings)
