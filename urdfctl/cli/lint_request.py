"""The request of a lint command."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.merging import merge
from urdfctl.lint.results import TargetResult
from urdfctl.lint.selection import Selection
from urdfctl.lint.shared_files import outcomes_of
from urdfctl.report import module_of
from urdfctl.startup.hints import TYPE_CHECKING
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.cli.known_findings import Baseline
    from urdfctl.discover.shards import Shard


class Fixing(NamedTuple):
    """The kind of fixes to apply.

    unsafe: also fixes that may change behaviour.
    as_diff: show the changes and write nothing.
    """

    unsafe: bool = False
    as_diff: bool = False


class Page(NamedTuple):
    """The HTML page of a run.

    path: its file.
    settings: of the run.
    began: when the run started, as time.monotonic() tells it.
    """

    path: str
    settings: Settings
    began: float


class LintRequest(NamedTuple):
    """The files, rules and outputs of a lint command.

    words: paths and name:=value arguments.
    outputs: formats, each with its file; None for standard output.
    jobs: how many robots at the same time; 0 for one for each processor.
    quiet: show only the findings.
    page: also write this page.
    cached: results of an earlier run may be used, and those of this one stored.
    """

    words: tuple[str, ...]
    selection: Selection
    outputs: tuple[tuple[str, str | None], ...]
    fail_on: Severity
    exit_zero: bool
    jobs: int
    config: Config = Config()
    baseline: Baseline | None = None
    statistics: bool = False
    fixing: Fixing | None = None
    shard: Shard | None = None
    cached: bool = False
    quiet: bool = False
    page: Page | None = None

    def import_reports(self) -> None:
        """Import what will write the reports, while the workers are busy."""
        for name, _ in self.outputs:
            module_of(name)

    def findings(self, results: Iterable[TargetResult]) -> list[Diagnostic]:
        """Return the findings in all targets, without those that per-file-ignores hides."""
        findings = merge(outcomes_of(results), self.selection)
        return [finding for finding in findings if not self.config.ignores(finding.at.file, finding.code)]
