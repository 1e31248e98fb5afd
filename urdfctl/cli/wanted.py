"""What a lint command was asked for."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.config import Config
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.hints import TYPE_CHECKING
from urdfctl.lint import Linted, Selection, joined
from urdfctl.record import NamedTuple
from urdfctl.report import module_of

if TYPE_CHECKING:
    from urdfctl.cli.known_findings import Baseline
    from urdfctl.shards import Shard


class Fixing(NamedTuple):
    """What is to be fixed, and how: also what is not sure, or only as a diff."""

    unsafe: bool = False
    as_diff: bool = False


class Wanted(NamedTuple):
    """What a lint command was asked for; `outputs` are formats with the file they go to, None for standard output."""

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

    def prepare_to_tell(self) -> None:
        """Load what will tell of the findings."""
        for name, _ in self.outputs:
            module_of(name)


def found_in(linted: Iterable[Linted], wanted: Wanted) -> list[Diagnostic]:
    """The findings in all that was linted, but for those that the configuration ignores in their files."""
    findings = joined([one.outcome for one in linted], wanted.selection)
    return [one for one in findings if not wanted.config.ignores(one.at.file, one.code)]
