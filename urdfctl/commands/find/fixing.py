"""`urdfctl lint --fix`, `--unsafe-fixes` and `--diff`."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.fix.rounds import FixOptions, fixed
from urdfctl.lint.findings.grouping import grouped
from urdfctl.lint.judging import LintRun
from urdfctl.lint.results import TargetResult
from urdfctl.lint.run import LintRequest, merge
from urdfctl.output.patch import patch
from urdfctl.output.printing import print_bytes, print_message
from urdfctl.output.writing_all import write_all
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


def fix(run: LintRun, request: LintRequest, *, unsafe: bool, as_diff: bool) -> Done:
    """Fix the files of a run, or show how; report what is not fixed, and why.

    unsafe: also with fixes that may change behaviour. as_diff: show the changes, and write nothing.
    """
    fix_options = FixOptions(request.selection, request.config.ignores, unsafe)
    result = fixed(tuple(run.targets), request.settings, fix_options, request.parallel)
    _print_lines(result.refused)
    _print_lines(result.remarks)
    if not as_diff:
        written = not (problems := write_all(result.changes))
        _print_lines(problems)
        return Done(len(result.changes) if written else 0, result.linted, failed=not written)
    print_bytes(patch(result.changes))
    return Done(len(result.changes), result.linted)


def report_fixes(
    done: Done, before: Iterable[TargetResult], request: LintRequest, *, unsafe: bool, as_diff: bool
) -> None:
    """Report how many findings are fixed, or would be, and how many more have an unsafe fix."""
    known, left = len(grouped(merge(before, request))), grouped(merge(done.left, request))
    verb = f"{'would fix' if as_diff else 'fixed'} {max(known - len(left), 0)}"
    more_unsafe = sum(finding.fix is not None and bool(finding.fix.edits) and not finding.fix.safe for finding in left)
    more = f"; use --unsafe-fixes to try {more_unsafe} more" if more_unsafe and not unsafe else ""
    _print_lines([f"{verb} of {_counted(known, 'finding')} in {_counted(done.files, 'file')}{more}"])


def _counted(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def _print_lines(lines: Iterable[str]) -> None:
    for line in lines:
        print_message(relative_message(line))
