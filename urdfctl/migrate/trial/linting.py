"""Lint the packages of a migration again and again, and only the targets that its changes may concern."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.config.file import config_for
from urdfctl.config.settings import Settings
from urdfctl.lint.judging import judge
from urdfctl.lint.results import TargetResult
from urdfctl.lint.run import InWorkers, LintRequest, Watch, find, in_workers, plan, unwatched
from urdfctl.load.target import Target
from urdfctl.migrate.packages import Linted
from urdfctl.migrate.trial.memory import Memory
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.rules import all_faults
from urdfctl.source.disk.files import is_launch, is_yaml
from urdfctl.startup.records import NamedTuple

_MOST_STATES = 4
"""So many results of a target are remembered: for the distro to migrate to, states with and without a step."""


class Lint:
    """Lints what is in the folders of a copy now, with all rules. watch: as in `lint`."""

    def __init__(self, scratch: Scratch, watch: Watch = unwatched) -> None:
        all_faults()  # many workers follow, which are forks: they need not import the rules
        self._scratch, self._watch = scratch, watch
        self._results = Memory[TargetResult](scratch, _MOST_STATES)
        self._variants = Memory[list[Target]](scratch, _MOST_STATES)

    def __call__(self, settings: Settings) -> Linted:
        """Return every target with its result, as `urdfctl lint` does."""
        config = config_for(tuple(self._scratch.folders), settings.workspace)
        request = LintRequest(tuple(self._scratch.folders), config, settings)
        launching = [path for path in self._scratch.files() if is_launch(path) or is_yaml(path)]
        workers = in_workers(request, self._watch)
        linter = _Remembering(workers, self._results, self._variants, launching)
        files = find(request).with_generated()  # a launch file may start what xacro wrote
        return judge(plan(files, request), linter).targets


class _Remembering(NamedTuple):
    """Lints targets in workers, except those whose result is known.

    launching: the files that decide which arguments launch files need.
    """

    workers: InWorkers
    results: Memory[TargetResult]
    choices: Memory[list[Target]]
    launching: Sequence[str]

    def lint(self, targets: Sequence[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[TargetResult]:
        """Yield the result of each target, in order. focus: as in `lint_target`, for each target."""
        wanted = list(zip(targets, map(tuple, focus or [()] * len(targets)), strict=True))
        found = [self.results.get((one, self.workers.request.settings.distro)) for one in wanted]
        new = [one for one, result in zip(wanted, found, strict=True) if result is None]
        linted = self.workers.lint([target for target, _ in new], [paths for _, paths in new])
        for one, result in zip(new, linted, strict=True):
            self.results.put((one, self.workers.request.settings.distro), result.files, result)
            found[found.index(None)] = result
        return (result for result in found if result is not None)

    def variants(self, targets: Sequence[Target]) -> list[list[Target]]:
        """Return, for each launch file, a target for each choice of the arguments that it needs."""
        found = [self.choices.get(target) for target in targets]
        new = [target for target, known in zip(targets, found, strict=True) if known is None]
        for target, choices in zip(new, self.workers.variants(new) if new else (), strict=True):
            self.choices.put(target, self.launching, choices)
            found[found.index(None)] = choices
        return [choices for choices in found if choices is not None]
