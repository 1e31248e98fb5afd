"""Find the robot that a command is about, with what lint would check it with: its controllers, its launch file."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from urdfctl.commands.progress import with_progress
from urdfctl.commands.words import split_arguments
from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.lint.judging import LintRun, judge
from urdfctl.lint.results import TargetResult
from urdfctl.lint.run import LintRequest, find, in_workers, plan
from urdfctl.lint.selection import Selection
from urdfctl.load.target import Target
from urdfctl.report.common import is_robot

if TYPE_CHECKING:
    from urdfctl.discover.shards import Shard

_NO_RULE = Selection(select=("UC000",))

Pair = tuple[Target, TargetResult]


def run_of(
    words: Sequence[str],
    config: Config,
    settings: Settings,
    *,
    shard: Shard | None = None,
    parallel: int | None = None,
) -> LintRun:
    """Return what lint reads for these paths and arguments, for a command that writes no report of findings.

    shard, parallel: as in `LintRequest`. Raises UserError if a path does not exist.
    """
    paths, arguments = split_arguments(words)
    request = LintRequest(
        paths=tuple(paths),
        config=config,
        settings=settings,
        selection=_NO_RULE,
        arguments=tuple(arguments.items()),
        shard=shard,
        parallel=parallel,
    )
    return judge(plan(find(request), request), in_workers(request, with_progress))


def robots_of(words: Sequence[str], config: Config, settings: Settings) -> list[Pair]:
    """Return the robots that lint checks for these paths and arguments, each with its result.

    Raises UserError if a path does not exist.
    """
    run = run_of(words, config, settings)
    known = {id(result) for result in run.robots}
    return [pair for pair in run.targets if id(pair[1]) in known and is_robot(pair[1])]


def best_of(
    pairs: Sequence[Pair], wanted: Callable[[TargetResult], bool] = lambda _: True, *, controlled: bool = False
) -> Pair | None:
    """Return the robot that says most: complete, with controllers, a launch file, most links; None if none is wanted.

    controlled: whether controllers count more than that every part could be expanded.
    """
    found = [pair for pair in pairs if wanted(pair[1])]
    return max(found, key=lambda pair: _weight(pair[1], controlled=controlled), default=None)


def _weight(result: TargetResult, *, controlled: bool) -> tuple[int, ...]:
    started = result.bringup is not None and bool(result.bringup.spawned)
    first, second = result.complete, bool(result.controllers)
    if controlled:
        first, second = second, first
    return not result.library, first, second, started, result.launch is not None, result.links or 0
