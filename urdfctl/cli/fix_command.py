"""`urdfctl lint --fix`, `--unsafe-fixes` and `--diff`."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.cli.lint_request import Fixing, LintRequest
from urdfctl.cli.patch import patch
from urdfctl.cli.writing import print_bytes, print_message
from urdfctl.cli.writing_all import write_all
from urdfctl.config.settings import Settings
from urdfctl.fix.rounds import Wishes, fixed
from urdfctl.lint.grouping import grouped
from urdfctl.lint.results import TargetResult
from urdfctl.load.target import Target
from urdfctl.report.common import relative_message
from urdfctl.startup.records import NamedTuple


class Done(NamedTuple):
    """The result of applying fixes.

    files: how many files were changed, or would be.
    left: the results after the fixes.
    failed: True if a file could not be written; then none is changed.
    """

    files: int
    left: tuple[TargetResult, ...]
    failed: bool = False


def fix(
    targets: Iterable[tuple[Target, TargetResult]], settings: Settings, request: LintRequest, fixing: Fixing
) -> Done:
    """Fix the files of some targets, or show how; report what is not fixed, and why."""
    wishes = Wishes(request.selection, request.config.ignores, fixing.unsafe)
    result = fixed(tuple(targets), settings, wishes, request.jobs or None)
    _print_lines(result.refused)
    _print_lines(result.remarks)
    if not fixing.as_diff:
        written = not (problems := write_all(result.changes))
        _print_lines(problems)
        return Done(len(result.changes) if written else 0, result.linted, failed=not written)
    print_bytes(patch(result.changes))
    return Done(len(result.changes), result.linted)


def report_fixes(
    files: int, before: Iterable[TargetResult], after: Iterable[TargetResult], request: LintRequest, fixing: Fixing
) -> None:
    """Report how many findings are fixed, or would be, and how many more have an unsafe fix."""
    known, left = len(grouped(request.findings(before))), grouped(request.findings(after))
    done = f"{'would fix' if fixing.as_diff else 'fixed'} {max(known - len(left), 0)}"
    unsafe = sum(finding.fix is not None and bool(finding.fix.edits) and not finding.fix.safe for finding in left)
    more = f"; use --unsafe-fixes to try {unsafe} more" if unsafe and not fixing.unsafe else ""
    _print_lines([f"{done} of {_counted(known, 'finding')} in {_counted(files, 'file')}{more}"])


def _counted(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def _print_lines(lines: Iterable[str]) -> None:
    for line in lines:
        print_message(relative_message(line))
