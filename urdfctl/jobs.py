"""Lints many targets, each in a worker that has little time and memory."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Iterator, Sequence
from functools import partial

from urdfctl.diagnostic import Finding, diagnosed
from urdfctl.hints import Any
from urdfctl.lint import Linted, Outcome, Selection
from urdfctl.load import Loader, Target
from urdfctl.rules import all_rules, rule_of
from urdfctl.serialise import linted_from_json, linted_to_json
from urdfctl.settings import Settings
from urdfctl.source import engine
from urdfctl.source.span import Place, SourceText
from urdfctl.worker import CAN_FORK, Died, Limits, processors, run

_SURVEYED_FROM = 4
"""So many targets are worth to learn of their workspace before workers part."""
_PREPARED_FROM = 12
"""From so many targets on it is cheaper to load everything once than what each needs in its worker."""


def lint_all(
    targets: Sequence[Target],
    settings: Settings,
    selection: Selection,
    parallel: int | None = None,
    meanwhile: Callable[[], object] = lambda: None,
) -> Iterator[Linted]:
    """The findings of each target, in their order, each from a limited worker. `meanwhile` is called while they
    work."""
    loader = shared_loader(targets, settings, selection)
    jobs = [job_for(target, settings, selection) for target in targets]
    limits = Limits(settings.timeout, settings.memory, settings.environ)
    parallel = parallel or processors()
    loader.may_part = CAN_FORK and len(targets) == 1 < parallel
    if loader.may_part and (targets[0].controllers or targets[0].launch):
        from urdfctl.sharing.assistant import Assistant

        loader.assistant = Assistant(limits)
    perform_job = partial(_perform_with, loader)

    def also() -> None:
        if loader.assistant is not None:
            loader.assistant.start()
        meanwhile()

    try:
        results = run(jobs, perform_job, limits, parallel, fresh="urdfctl.jobs:perform", together=16, meanwhile=also)
        for target, result in zip(targets, results, strict=True):
            yield linted_from_json(result) if isinstance(result, dict) else dead(target, settings, result)
    finally:
        if loader.assistant is not None:
            loader.assistant.dismiss()


def shared_loader(targets: Sequence[Target], settings: Settings, selection: Selection) -> Loader:
    """A loader for workers, which knows what each of many targets would else learn for itself."""
    loader = Loader(settings, selection)
    if len(targets) >= _SURVEYED_FROM:
        loader.survey(targets)
    if len(targets) >= _PREPARED_FROM:
        _prepare()
    return loader


def _prepare() -> None:
    """Load what the workers would else load again and again; they share it as long as nobody writes to it."""
    import urdfctl.launching
    import urdfctl.pairing  # noqa: F401
    from urdfctl.catalog.store import prepare

    all_rules()
    prepare()
    engine.release(engine.load())
    gc.freeze()


def job_for(target: Target, settings: Settings, selection: Selection) -> dict[str, Any]:
    """What a worker is told of a target."""
    return {"target": target._asdict(), "settings": settings.to_json(), "selection": selection._asdict()}


def _perform_with(loader: Loader, job: dict[str, Any]) -> dict[str, Any]:
    return linted_to_json(loader.lint(target_of(job)))


def target_of(job: dict[str, Any]) -> Target:
    """The target of a job."""
    arguments = tuple((str(name), str(value)) for name, value in job["target"]["arguments"])
    target = job["target"]
    return Target(target["path"], arguments, target["fragment"], tuple(target["controllers"]), target["launch"])


def perform(job: dict[str, Any]) -> dict[str, Any]:
    """Lint the target of a job that came as JSON."""
    return _perform_with(loader_of(job), job)


def loader_of(job: dict[str, Any]) -> Loader:
    """A loader with the settings of a job that came as JSON."""
    return Loader(Settings.from_json(job["settings"]), Selection.from_json(job["selection"]))


def dead(target: Target, settings: Settings, death: Died) -> Linted:
    """A worker's death as the one finding of its robot."""
    path = os.path.abspath(target.path)
    place = Place(SourceText(path, b""), 0, end=0)
    rule = rule_of("UC000" if death.ours else "UC014")
    message = f"urdfctl crashed: {death.why}" if death.ours else f"the description is not linted: {death.why}"
    finding = diagnosed(rule.code, rule.name, rule.severity, Finding(place, message))
    outcome = Outcome([finding], [], crashed=death.ours)
    distro, simulator = settings.distro, settings.simulator
    return Linted(path, None, distro, None, simulator, False, target.fragment, None, None, (path,), outcome)  # noqa: FBT003
