"""Lint in this process, from texts that may not be saved yet, and again only what a change concerns."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import partial

from urdfctl.config.settings import Settings
from urdfctl.lint.job import failed, job_for, lint_work, perform, variants_work
from urdfctl.lint.results import TargetResult
from urdfctl.lint.selection import Selection
from urdfctl.lint.serialising import result_from_json
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.run.here import run_all_here
from urdfctl.run.limits import Json, Limits, Result
from urdfctl.source.disk.shown import real_path

Focus = tuple[str, ...]
_now = getattr(time, "thread_time", time.monotonic)  # a browser has no threads


class Outdated(Exception):
    """What is being linted has changed meanwhile."""


class LiveLinter:
    """Lints targets and remembers their results until a file that they read changes.

    seconds: how long each target took the last time, in seconds of processor time.
    overlay: the texts to read instead of the files on disk, by real path.
    is_outdated: asked before each target that is not known; if it returns True, Outdated is raised.
    """

    def __init__(
        self,
        settings: Settings,
        selection: Selection,
        overlay: Mapping[str, bytes],
        is_outdated: Callable[[], bool] = lambda: False,
    ) -> None:
        self.settings, self.selection = settings, selection
        self._is_outdated = is_outdated
        self._limits = Limits(settings.timeout, settings.memory, settings.environ)
        self._loader = Loader(settings, overlay)
        self._results: dict[tuple[Target, Focus], TargetResult] = {}
        self._variants: dict[Target, list[Target]] = {}
        self.seconds: dict[Target, float] = {}

    def changed(self, overlay: Mapping[str, bytes], paths: Collection[str]) -> None:
        """Read these texts from now on, and forget what was found in targets that read one of the paths.

        paths: real paths of files whose text changed; none was created or deleted.
        """
        changed = set(paths)
        self._loader = self._loader.with_overlay(overlay, changed)
        self._variants.clear()
        kept = (pair for pair in self._results.items() if changed.isdisjoint(map(real_path, pair[1].files)))
        self._results = dict(kept)

    def lint(self, targets: Sequence[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[TargetResult]:
        """Yield the result of each target, in order. focus: as in `lint_target`, for each target."""
        for target, paths in zip(targets, focus or [()] * len(targets), strict=True):
            key = target, tuple(paths)
            if key not in self._results:
                self._results[key] = self._lint(target, {"focus": list(paths)})
            yield self._results[key]

    def variants(self, targets: Sequence[Target]) -> list[list[Target]]:
        """Return, for each launch file, a target for each choice of the arguments that it needs."""
        for target in targets:
            if target not in self._variants:
                result = self._result(job_for(variants_work, target, self.settings))
                found = [Target.from_json(one) for one in result["targets"]] if isinstance(result, dict) else [target]
                self._variants[target] = found
        return [self._variants[target] for target in targets]

    def _lint(self, target: Target, details: Json) -> TargetResult:
        job = job_for(lint_work, target, self.settings, selection=self.selection, details=details)
        started = _now()
        result = self._result(job)
        self.seconds[target] = _now() - started
        return result_from_json(result) if isinstance(result, dict) else failed(target, self.settings, result)

    def _result(self, job: Json) -> Result:
        if self._is_outdated():
            raise Outdated
        shared = partial(perform, self._loader)
        return next(run_all_here([job], shared, self._limits))
