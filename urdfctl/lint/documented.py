"""Launch files are checked with the arguments with which READMEs and scripts start them, too."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from urdfctl.lint.chosen import LintPairs, Variants
from urdfctl.lint.joining import Pair
from urdfctl.load.target import Target


def documented_starts(
    inner: Iterable[Target], started: Collection[Pair], variants: Variants, lint: LintPairs
) -> list[Pair]:
    """Return the documented starts of launch files that others include, where nothing else starts the same robot with
    the same controllers.

    inner: the launch files, with the arguments that are documented. started: the results of those that were started.
    """
    asked = [target for target in inner if target.documented]
    choices = variants(asked) if asked else []
    targets = [one for found in choices for one in found if one.arguments and not one.guessed]
    known = {_controlled(pair) for pair in started}
    return [pair for pair in lint(targets) if pair[1].is_controlled and _controlled(pair) not in known]


def _controlled(pair: Pair) -> tuple[object, ...]:
    """The robot that a target starts, with its controllers."""
    result = pair[1]
    return result.path, result.arguments, result.controllers, result.bringup and result.bringup.spawned
