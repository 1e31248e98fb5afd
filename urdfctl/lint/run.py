"""A run of lint in stages, as `lint` calls them: find, plan, load and judge, merge, report.

A command and the language server run the same stages. Only what loads and judges differs: `InWorkers`, or `LiveLinter`
for open texts.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import closing
from typing import TYPE_CHECKING

from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.discover.robots import DiscoveredFiles
from urdfctl.errors import UserError
from urdfctl.lint import planning
from urdfctl.lint.findings import merging
from urdfctl.lint.findings.grouping import grouped
from urdfctl.lint.findings.ranking import causes_first
from urdfctl.lint.job import Workers, launch_variants, lint_all
from urdfctl.lint.judging import LintRun, judge
from urdfctl.lint.planning import Arguments, Plan, of_shard
from urdfctl.lint.results import Report, TargetResult
from urdfctl.lint.selection import Selection
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.names import did_you_mean
from urdfctl.run.fork import Standby
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.config.definitions import Nodes
    from urdfctl.discover.shards import Shard
    from urdfctl.lint.cache import RunCache


class LintRequest(NamedTuple):
    """What a run lints, and how.

    paths: files and folders; the package around the current folder if empty.
    selection: the rules.
    arguments: given to each description, as names with values.
    shard: the share of the files to lint; all if None.
    parallel: how many workers run at the same time; one for each processor if None.
    """

    paths: tuple[str, ...]
    config: Config
    settings: Settings
    selection: Selection = Selection()
    arguments: Arguments = ()
    shard: Shard | None = None
    parallel: int | None = None


Watch = Callable[[Iterator[TargetResult], int], Iterator[TargetResult]]
"""Is given results as they come, with their number, and gives them back."""


def unwatched(results: Iterator[TargetResult], _number: int) -> Iterator[TargetResult]:
    """Give results back as they are."""
    return results


def _nothing() -> None:
    return None


def lint(
    request: LintRequest,
    *,
    watch: Watch = unwatched,
    meanwhile: Callable[[], object] = _nothing,
    is_cached: bool = False,
) -> LintRun:
    """Return the results of what the paths of a request mean; `merge` and `report` make findings and a report of them.

    meanwhile: is called while the workers are busy.
    is_cached: results of an earlier run may be used, and those of this one stored.
    Raises UserError if there is nothing to lint.
    """
    cache = _cache(request) if is_cached else None
    stored = cache.load() if cache else None
    run = _linted(request, watch, meanwhile) if stored is None else stored
    if cache and stored is None:
        cache.store(run)
    if request.settings.nodes:
        _check_nodes(request.settings.nodes, run.results)
    return run


def _cache(request: LintRequest) -> RunCache:
    from urdfctl.lint.cache import RunCache

    asked = request._replace(settings=Settings(), parallel=None)
    file = request.config.file
    return RunCache(request.paths, request.settings, asked, extra=[file] if file else ())


def _linted(request: LintRequest, watch: Watch, meanwhile: Callable[[], object]) -> LintRun:
    where = ", ".join(request.paths) or "this folder"
    files = find(request)
    if not files.paths():
        raise UserError(
            f"nothing to lint in {where}: name a robot (.urdf, .xacro), a controller file (.yaml) or a launch file, or "
            "a folder that contains one"
        )
    with closing(Standby()) as standby:
        workers = Workers(Loader(request.settings), request.parallel, standby=standby, meanwhile=meanwhile)
        run = judge(plan(files, request), InWorkers(request, workers, watch))
    is_named = any(each.controls or not each.packages for each in run.unjoined)  # by the last line of the report
    if not run.results and not is_named and request.shard is None:
        absent = sorted({repr(name) for each in run.unjoined for name in each.packages})
        raise UserError(
            f"nothing to lint in {where}: it contains launch files, but they start no robot or controllers of this "
            f"workspace{'; not in it: ' * bool(absent)}{', '.join(absent)}"
        )
    return run


def _check_nodes(nodes: Nodes, results: Sequence[TargetResult]) -> None:
    """UserError if no file has parameters for a node: nothing would have been checked."""
    checked = {name for result in results for name in result.nodes}
    there = {name for result in results for name in result.sections}
    for name, _ in nodes:
        if name not in checked:
            raise UserError(f"--node {name}: no file has parameters for a node of this name{did_you_mean(name, there)}")


# -- find and plan ---------------------------------------------------------------------------------------------------


def find(request: LintRequest) -> DiscoveredFiles:
    """Return the files that the paths of a request mean. UserError says what is wrong with a path."""
    return planning.discovered(request.paths, request.config)


def plan(files: DiscoveredFiles, request: LintRequest) -> Plan:
    """Return the targets that some files are at first sight."""
    robots = request.config.robots
    targets = planning.planned(files, request.arguments, robots)
    return Plan(files, targets) if request.shard is None else Plan(*of_shard(files, targets, request.shard, robots))


# -- load and judge, in workers --------------------------------------------------------------------------------------


class InWorkers(NamedTuple):
    """Loads targets and runs the rules on them, in limited workers."""

    request: LintRequest
    workers: Workers
    watch: Watch

    def lint(self, targets: Sequence[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[TargetResult]:
        """Yield the result of each target, in order. focus: as in `lint_target`, for each target."""
        request = self.request
        results = lint_all(targets, request.settings, request.selection, focus=focus, workers=self.workers)
        return self.watch(results, len(targets))

    def variants(self, targets: Sequence[Target]) -> list[list[Target]]:
        """Return, for each launch file, a target for each choice of the arguments that it needs."""
        return launch_variants(targets, self.request.settings, self.workers)


def in_workers(request: LintRequest, watch: Watch = unwatched) -> InWorkers:
    """Return what lints the targets of a request, each in workers of its own. watch: as in `lint`."""
    return InWorkers(request, Workers(Loader(request.settings), request.parallel), watch)


# -- merge and report ------------------------------------------------------------------------------------------------


def merge(results: Iterable[TargetResult], request: LintRequest) -> list[Diagnostic]:
    """Return the findings of all targets, each fault once, without those that per-file-ignores hides."""
    findings = merging.merge(merging.outcomes_of(results), request.selection)
    return [finding for finding in findings if not request.config.ignores(finding.at.file, finding.code)]


def report(
    run: LintRun,
    request: LintRequest,
    *,
    fail_on: Severity = Severity.ERROR,
    unknown: Callable[[list[Diagnostic], Collection[str]], list[Diagnostic]] | None = None,
) -> Report:
    """Return the report of a run: its findings, merged and grouped, and what was linted.

    fail_on: the severity from which findings fail the run.
    unknown: given the findings and the files that were read, returns the findings that no baseline has.
    """
    findings = merge(run.results, request)
    left = findings
    if unknown is not None:
        left = unknown(findings, {file for result in run.results for file in result.files})
    return Report(
        targets=tuple(run.robots),
        findings=tuple(causes_first(grouped(left))),
        unused=tuple(result.path for result in run.unused),
        fail_on=fail_on,
        known=len(findings) - len(left),
        unjoined=run.unjoined,
        missing_packages=tuple(sorted({name for result in run.results for name in result.missing_packages})),
        uncontrolled=_uncontrolled(run.robots),
    )


def _uncontrolled(robots: Sequence[TargetResult]) -> str:
    """The path of the first robot if nothing of any robot is controlled."""
    whole = [result for result in robots if result.links]
    return whole[0].path if whole and all(result.idle for result in whole) else ""
