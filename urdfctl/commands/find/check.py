"""`urdfctl check`: lint and smoke in one run, with one report and one exit status."""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Sequence

from urdfctl.commands.declaring import OUTPUT, Command, option
from urdfctl.commands.find.lint import LintOptions, fail_on_of, request_of
from urdfctl.commands.find.smoke import SmokeOptions, smoke_status, tested, with_progress_of_tests, write_smoke
from urdfctl.commands.options import FORMAT
from urdfctl.commands.progress import with_progress
from urdfctl.commands.words import baseline_of, contradictions, outputs_of
from urdfctl.diagnostic import Diagnostic
from urdfctl.lint.judging import LintRun
from urdfctl.lint.run import lint, report
from urdfctl.output.links import check_output
from urdfctl.output.printing import print_messages
from urdfctl.output.writing import write_file
from urdfctl.smoke.curves import curves_as_csv
from urdfctl.smoke.lifecycle import LINT_REPORTS_IT
from urdfctl.smoke.reports import SMOKE_FORMATS, SmokeReport, report_of


class LintAndSmokeOptions(SmokeOptions, command="check"):
    """Lint robots, and load, start and move each of their controllers: all that a pipeline asks, in one report.

    \b
    Example: urdfctl check .
             urdfctl check . --engine none --format github
    """

    formats: tuple[str, ...] = option(OUTPUT, FORMAT, "--format", choices=tuple(SMOKE_FORMATS))


def run_check(options: LintAndSmokeOptions) -> int:
    """Lint and test the robots that the options name, report both as one, and return the exit status."""
    began = time.monotonic()
    outputs = outputs_of(options.formats, options.output_file, SMOKE_FORMATS)
    check_output(options.report)
    shared = {name: value for name, value in options.values().items() if name in LintOptions.declared}
    of_lint = LintOptions(**{**shared, "formats": ()})
    request = request_of(of_lint)
    baseline = baseline_of(of_lint, [request.config], request.selection, found_by="lint")
    print_messages(contradictions(request.config, options.distro))
    run = lint(request, watch=with_progress)
    linted = report(run, request, fail_on=fail_on_of(of_lint, request), unknown=baseline and baseline.unknown)
    tests, smoked = (
        tested(options, with_progress_of_tests)
        if any(result.links for result in run.robots)
        else ([], report_of((), ()))
    )
    whole = linted._replace(
        findings=(*linted.findings, *_new(smoked.found.findings, run)),
        quiet=options.quiet,
        verbose=options.verbose,
        statistics=options.statistics,
    )
    made = SmokeReport(smoked.robots, whole, allow_empty=True)
    for name, file in outputs:
        write_smoke(made, name, file)
    if options.csv:
        write_file(options.csv, curves_as_csv(made.robots), force=True)
    if options.report:
        from urdfctl.page.writing import write_smoke_page

        pairs = [((test.settings, test.target), robot) for test, robot in zip(tests, made.robots, strict=True)]
        write_smoke_page(options.report, made, pairs, began=began, watch=with_progress, kind="Check")
    return 3 if run.crashed else smoke_status(made, exit_zero=options.exit_zero)


def _new(findings: Sequence[Diagnostic], run: LintRun) -> list[Diagnostic]:
    """What the smoke test found and lint did not: a controller also fails by what lint reports at the same place."""
    told = defaultdict[tuple[str, int], list[Diagnostic]](list)
    said = set[str]()
    for result in run.results:
        for one in result.outcome.diagnostics:
            told[one.at.file, one.at.line].append(one)
            said.add(one.message)
    return [
        one
        for one in findings
        if one.message not in said and not any(_is_told(one, other) for other in told[one.at.file, one.at.line])
    ]


def _is_told(smoked: Diagnostic, linted: Diagnostic) -> bool:
    return linted.message in smoked.message or any(
        note.message == f"{LINT_REPORTS_IT}{linted.code}" for note in smoked.notes
    )


command = Command(LintAndSmokeOptions, run_check)
