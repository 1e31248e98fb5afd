"""Lint what a command asks for, in workers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.cli.lint_request import LintRequest
from urdfctl.cli.progress import with_progress
from urdfctl.config.settings import Settings
from urdfctl.discover.robots import DiscoveredFiles
from urdfctl.lint import files as whole_runs
from urdfctl.lint.files import LintRun
from urdfctl.lint.job import launch_variants, lint_all
from urdfctl.lint.planning import Arguments
from urdfctl.lint.results import TargetResult
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.startup.records import NamedTuple


class InWorkers(NamedTuple):
    """Lints targets in limited workers, with a progress bar."""

    settings: Settings
    request: LintRequest
    loader: Loader

    def lint(self, targets: Sequence[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[TargetResult]:
        """Yield the result of each target, in order."""
        results = lint_all(
            targets,
            self.settings,
            self.request.selection,
            focus=focus,
            loader=self.loader,
            parallel=self.request.jobs or None,
            meanwhile=self.request.import_reports,
        )
        return with_progress(results, len(targets))

    def variants(self, targets: Sequence[Target]) -> list[list[Target]]:
        """Return, for each launch file, a target for each choice of the arguments that it needs."""
        return launch_variants(targets, self.settings, self.loader, self.request.jobs or None)


def lint_files(files: DiscoveredFiles, arguments: Arguments, settings: Settings, request: LintRequest) -> LintRun:
    """Lint the robots among some files as a command asks for it, then the files that none of them uses."""
    linter = InWorkers(settings, request, Loader(settings))
    return whole_runs.lint_files(files, arguments, linter, request.config.robots, request.shard)
