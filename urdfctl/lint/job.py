"""Do something with each of many targets in limited workers: lint it, expand it, measure it, test a fix, smoke it."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from importlib import import_module
from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Finding, diagnosed
from urdfctl.fault import Fault
from urdfctl.lint.results import Outcome, TargetResult
from urdfctl.lint.selection import Selection
from urdfctl.lint.serialising import outcome_from_json, result_from_json, result_to_json
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.rules import all_faults
from urdfctl.run.fork import Standby
from urdfctl.run.limits import Json, Limits, Result, WorkerFailure, processors
from urdfctl.run.pool import Division, Meanwhile, run_jobs
from urdfctl.run.waiting import BAR_FROM
from urdfctl.source.disk.files import is_launch
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xacro.private import private_module
from urdfctl.startup.records import NamedTuple

_INDEX_FROM = 4
"""From this many targets on, index packages once before forking."""
_PRELOAD_FROM = 12
"""From this many targets on, import all rules once before forking: cheaper than what each worker needs."""
_TARGETS_PER_WORKER = 64


class Work(NamedTuple):
    """One target in a worker, with what it needs.

    details: what else the job needs, as plain data.
    """

    loader: Loader
    target: Target
    selection: Selection
    details: Json


WorkFunction = Callable[[Work], Json]
"""A function of a module, so that a fresh process can import it."""


def _nothing() -> None:
    return None


class Workers(NamedTuple):
    """Settings of the workers.

    loader: shared by forked workers; a new one if None.
    parallel: how many workers run at the same time; one for each processor if None.
    targets_per_worker: how many targets a forked worker may take, each within the limits.
    standby: workers of other targets of the same run and loader, which have read what they share; None: there are none.
    meanwhile: called once, after the first workers were started.
    """

    loader: Loader | None = None
    parallel: int | None = None
    targets_per_worker: int = 1
    standby: Standby | None = None
    meanwhile: Callable[[], object] = _nothing


def run_on_targets(
    function: WorkFunction,
    targets: Sequence[Target],
    settings: Settings,
    selection: Selection | None = None,
    *,
    details: Sequence[Json] | None = None,
    workers: Workers = Workers(),  # noqa: B008 (immutable)
) -> Iterator[Result]:
    """Yield what `function` returns for each target, in order, or why it returned nothing.

    selection: all rules if None.
    details: for each target, what the job needs besides; plain data.
    """
    jobs = [
        job_for(function, target, settings, selection=selection, details=its_details)
        for target, its_details in zip(targets, details or [{}] * len(targets), strict=True)
    ]
    return run_jobs(
        jobs,
        partial(perform, workers.loader or Loader(settings)),
        Limits(settings.timeout, settings.memory, settings.environ),
        workers.parallel or processors(),
        function_name="urdfctl.lint.job:perform_alone",
        division=Division(workers.targets_per_worker, list(map(_folder_of_launch, targets)), workers.standby),
        meanwhile=Meanwhile(workers.meanwhile, _doing(targets)),
    )


def _doing(targets: Sequence[Target]) -> str:
    """What a user who waits is told; nothing where there is a bar."""
    if len(targets) >= BAR_FROM:
        return ""
    what = os.path.basename(targets[0].path) if len(targets) == 1 else f"{len(targets)} robots"
    return f"working on {what}"


def _folder_of_launch(target: Target) -> str:
    """The folder of a launch file, whose others often start the same robot; empty for other targets."""
    return os.path.dirname(target.path) if is_launch(target.path) else ""


def run_on_one(
    function: WorkFunction, target: Target, settings: Settings, details: Json | None = None
) -> tuple[dict[str, Any] | None, Outcome]:
    """Return what `function` returns for one target, and its outcome; None and the reason if it returned nothing.

    function: gives its outcome as plain data, under the key `outcome`. details: what it needs besides; plain data.
    """
    [result] = run_on_targets(function, [target], settings, details=[details or {}])
    if isinstance(result, dict):
        return result, outcome_from_json(result["outcome"])
    return None, failed(target, settings, result).outcome


def job_for(
    function: WorkFunction,
    target: Target,
    settings: Settings,
    *,
    selection: Selection | None = None,
    details: Json | None = None,
) -> Json:
    """Return a job as plain data, complete for `perform_alone`."""
    return {
        "function": f"{function.__module__}:{function.__name__}",
        "target": target._asdict(),
        "settings": settings.to_json(),
        "selection": (selection or Selection())._asdict(),
        "details": details or {},
    }


def perform(loader: Loader, job: Json) -> Json:
    """Do a job with what this process shares among its jobs."""
    target, selection = Target.from_json(job["target"]), Selection.from_json(job["selection"])
    module, _, name = job["function"].partition(":")
    function: WorkFunction = getattr(import_module(module), name)
    with loader.reading_for(target.path):
        return function(Work(loader, target, selection, job["details"]))


def perform_alone(job: Json) -> Json:
    """Do a job in a process that knows nothing but the job."""
    return perform(Loader(Settings.from_json(job["settings"])), job)


# -- linting ---------------------------------------------------------------------------------------------------------


def lint_all(
    targets: Sequence[Target],
    settings: Settings,
    selection: Selection,
    *,
    focus: Sequence[Sequence[str]] = (),
    workers: Workers = Workers(),  # noqa: B008 (immutable)
) -> Iterator[TargetResult]:
    """Yield the findings of each target, in order, each from a limited worker.

    focus: as in `lint_target`, for each target; no target has one if empty.
    """
    if not targets:
        return
    loader = shared_loader(targets, settings, workers.loader)
    workers = workers._replace(loader=loader, targets_per_worker=_TARGETS_PER_WORKER)
    details = [{"focus": list(paths)} for paths in focus] or None
    results = run_on_targets(lint_work, targets, settings, selection, details=details, workers=workers)
    for target, result in zip(targets, results, strict=True):
        yield result_from_json(result) if isinstance(result, dict) else failed(target, settings, result)


def lint_work(work: Work) -> Json:
    """Lint a target in a worker."""
    focus = work.details.get("focus", ())
    return result_to_json(lint_target(work.loader, work.target, work.selection, focus=focus).result)


def launch_variants(targets: Sequence[Target], settings: Settings, workers: Workers) -> list[list[Target]]:
    """Return, for each launch file, a target for each choice of the arguments that it needs, or only itself."""
    results = run_on_targets(variants_work, targets, settings, workers=workers)
    return [
        [Target.from_json(one) for one in result["targets"]] if isinstance(result, dict) else [target]
        for target, result in zip(targets, results, strict=True)
    ]


def variants_work(work: Work) -> Json:
    """Find the variants of a launch file in a worker."""
    return {"targets": [target._asdict() for target in work.loader.variants(work.target)]}


def shared_loader(targets: Sequence[Target], settings: Settings, loader: Loader | None = None) -> Loader:
    """Return a loader for forked workers that already knows what each of many targets needs."""
    loader = loader or Loader(settings)
    if len(targets) >= _INDEX_FROM:
        loader.index_packages(targets)
    if len(targets) >= _PRELOAD_FROM:
        loader.read_exports(targets)
        _preload()
    return loader


def _preload() -> None:
    """Import what workers need; forks share its memory until somebody writes to it."""
    import urdfctl.load.controller_files
    import urdfctl.load.launch_files  # noqa: F401
    from urdfctl.catalog.store import prepare

    all_faults()
    prepare()
    private_module.load()
    gc.freeze()


def failed(target: Target, settings: Settings, failure: WorkerFailure) -> TargetResult:
    """Return the result of a target whose worker failed: one finding that says why."""
    from urdfctl.rules.reading.over_budget import over_budget
    from urdfctl.rules.reading.rule_crashed import rule_crashed

    path = os.path.abspath(target.path)
    place = Place(SourceText(path, b""), 0, end=0)
    fault: Fault = over_budget
    message = f"the description is not linted: {failure.reason}"
    if failure.our_fault:
        fault, message = rule_crashed, rule_crashed.message("urdfctl", failure.reason)
    finding = diagnosed(fault.code, fault.name, fault.severity, Finding(place, message), fault.url)
    return TargetResult(
        path=path,
        ros=None,
        distro=settings.distro,
        distro_from=None,
        simulator=settings.simulator,
        complete=False,
        library=target.fragment,
        robot=None,
        links=None,
        files=(path,),
        outcome=Outcome([finding], [], crashed=failure.our_fault),
    )
