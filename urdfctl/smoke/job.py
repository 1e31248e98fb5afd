"""The smoke test of many robots: each is read and judged in one limited worker, and moved in another, fresh one."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

from urdfctl.lint import Selection
from urdfctl.load import Loader, Target, dead
from urdfctl.serialise import linted_from_json, linted_to_json
from urdfctl.settings import Settings
from urdfctl.smoke.judgement import judged
from urdfctl.smoke.results import ControllerResult, Smoked
from urdfctl.worker import Limits, run


class Wanted(NamedTuple):
    """What is asked of a smoke test: only the controllers of some names (all where there are none)."""

    only: tuple[str, ...] = ()


def smoke_all(
    targets: Sequence[Target], settings: Settings, wanted: Wanted, parallel: int | None = None
) -> Iterator[Smoked]:
    """The smoke test of each target, in their order."""
    loader = Loader(settings, Selection())
    jobs = [
        {"target": target._asdict(), "settings": settings.to_json(), "wanted": wanted._asdict()} for target in targets
    ]
    limits = Limits(settings.timeout, settings.memory, settings.environ)
    parallel = parallel or os.cpu_count() or 1
    results = run(jobs, partial(_perform_with, loader), limits, parallel, fresh="urdfctl.smoke.job:perform")
    for target, result in zip(targets, results, strict=True):
        yield _smoked(result) if isinstance(result, dict) else Smoked(dead(target, settings, result))


def perform(job: dict[str, Any]) -> dict[str, Any]:
    """The structural part of the smoke test of a job that came as JSON."""
    return _perform_with(Loader(Settings.from_json(job["settings"]), Selection()), job)


def _perform_with(loader: Loader, job: dict[str, Any]) -> dict[str, Any]:
    data = job["target"]
    arguments = tuple((str(name), str(value)) for name, value in data["arguments"])
    target = Target(data["path"], arguments, controllers=tuple(data["controllers"]), launch=data["launch"])
    smoked = judged(loader.seen(target), job["wanted"]["only"]).smoked
    return {"linted": linted_to_json(smoked.linted), "controllers": [one.to_json() for one in smoked.controllers]}


def _smoked(data: dict[str, Any]) -> Smoked:
    results = tuple(ControllerResult.from_json(one) for one in data["controllers"])
    return Smoked(linted_from_json(data["linted"]), results)
