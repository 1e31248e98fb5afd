"""Launch files that others include, checked in a start of their own.

That is the start that an argument makes with which others include them; or the one with which people start them alone.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence

from urdfctl.discover.included import included_in
from urdfctl.discover.walk import text_of
from urdfctl.lint.joining import Pair, is_lonely
from urdfctl.lint.results import TargetResult
from urdfctl.load.target import Target

Variants = Callable[[list[Target]], list[list[Target]]]
LintPairs = Callable[[list[Target]], Iterable[Pair]]


def chosen_starts(started: Sequence[Pair], joined: Collection[int], variants: Variants, lint: LintPairs) -> list[Pair]:
    """Return the starts, with an argument that is not the default, of launch files that start controllers without a
    robot, are joined with nothing, and are included nowhere.

    started: the results of launch files.
    joined: the identities of those that are joined.
    """
    included = {path for _, result in started if result.bringup for path in result.bringup.includes}
    left = {result.path for _, result in started if is_lonely(result) and id(result) not in joined} - included
    asked = [
        Target(result.launch, towards=path)
        for _, result in started
        if left and result.launch and result.links and result.bringup and not result.bringup.arguments
        for path in _may_include(result, left)
    ]
    found: dict[str, Target] = {}
    for target, choices in zip(asked, variants(asked) if asked else (), strict=True):
        if target.towards and choices[0].arguments:
            found.setdefault(target.towards, choices[0]._replace(towards=None))
    results = list(lint(list(dict.fromkeys(found.values()))))
    return [pair for pair in results if pair[1].links]


def _may_include(start: TargetResult, paths: Collection[str]) -> Iterator[str]:
    """Yield those of some launch files that a start may include, as far as its texts name them."""
    if start.bringup is None or start.launch is None:
        return
    by_name: dict[str, list[str]] = {}
    for path in sorted(paths):
        by_name.setdefault(os.path.basename(path), []).append(path)
    files = (os.path.abspath(start.launch), *start.bringup.includes)
    named = (path for file in files for path in included_in(file, text_of(file), by_name).every)
    followed = (path for path in start.bringup.unfollowed if path in paths)
    yield from dict.fromkeys([*followed, *(path for path in named if path not in start.bringup.includes)])


def documented_starts(
    inner: Iterable[Target], started: Collection[Pair], variants: Variants, lint: LintPairs
) -> list[Pair]:
    """Return the documented starts of launch files that others include, where nothing else starts the same robot with
    the same controllers, and those of robots in packages that are not here.

    inner: the launch files, with the arguments that are documented, and the place that documents a start without any.
    started: the results of those that were started.
    """
    asked = [target for target in inner if target.documented]
    choices = variants(asked) if asked else []
    targets = [one._replace(documented=()) for one in inner if one.told_at]
    targets += [one for found in choices for one in found if one.arguments and not one.guessed]
    known = {_controlled(pair) for pair in started}
    found = [pair for pair in lint(targets) if pair[1].is_controlled or pair[1].joining.described_in]
    return [pair for pair in found if _controlled(pair) not in known]


def _controlled(pair: Pair) -> tuple[object, ...]:
    """The robot that a target starts, with its controllers, and whether MoveIt plans for it."""
    result, bringup = pair[1], pair[1].bringup
    return result.path, result.arguments, result.controllers, bringup and (bringup.spawned, bringup.moveit)
