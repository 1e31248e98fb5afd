"""`urdfctl lint`."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from urdfctl.commands.declaring import FIXES, LIMITS, OUTPUT, RULES, Command, Reads, option
from urdfctl.commands.options import FORMAT, CheckOptions, ReportOptions
from urdfctl.commands.progress import with_progress
from urdfctl.commands.words import (
    baseline_of,
    check_jobs,
    codes,
    configured,
    contradictions,
    outputs_of,
    settings_to_check,
    severity_named,
    shard_of,
    split_arguments,
)
from urdfctl.diagnostic import Severity
from urdfctl.errors import UserError
from urdfctl.lint.findings.merging import worst
from urdfctl.lint.judging import LintRun
from urdfctl.lint.results import Report
from urdfctl.lint.run import LintRequest, lint, report
from urdfctl.lint.selection import Selection, selection_with
from urdfctl.output.printing import is_coloured, print_message, print_messages, print_text
from urdfctl.output.writing import write_file
from urdfctl.report import FORMATS, module_of, render
from urdfctl.report.common import about_missing_packages

Outputs = Sequence[tuple[str, str | None]]
"""Formats of the report, each with its file; None for standard output."""


class LintOptions(CheckOptions, ReportOptions):
    """Find what keeps a robot from loading, starting and moving.

    \b
    Example: urdfctl lint urdf/robot.xacro reach:=0.6 --distro jazzy
    """

    select: tuple[str, ...] = option(RULES, "Select rules by code or prefix, e.g. UC2,UC401.", metavar="CODE,...")
    ignore: tuple[str, ...] = option(RULES, "Ignore rules by code or prefix.", metavar="CODE,...")
    extend_select: tuple[str, ...] = option(RULES, "Select these rules in addition.", metavar="CODE,...")
    formats: tuple[str, ...] = option(OUTPUT, FORMAT, "--format", choices=FORMATS)
    quiet: bool = option(OUTPUT, "Show only the findings, without a summary.", "-q", "--quiet")
    no_cache: bool = option(LIMITS, "Neither use results of an earlier run nor store those of this one.")
    show_settings: bool = option(OUTPUT, "Show the effective settings and where each comes from, then exit.")
    fix: bool = option(FIXES, "Apply safe fixes.")
    unsafe_fixes: bool = option(FIXES, "Also apply fixes that may change behaviour.")
    node: tuple[str, ...] = option(
        RULES,
        "Check the parameters of a node by their definition for generate_parameter_library: NAME=FILE.",
        metavar="NAME=FILE",
        reads=Reads.PLACE_AFTER_NAME,
    )
    diff: bool = option(FIXES, "Show fixes as a diff and write nothing. Exit with status 1 if there are any.")

    @property
    def fixes(self) -> bool:
        """Whether anything is to be fixed, or shown how."""
        return self.fix or self.unsafe_fixes or self.diff


def run_lint(options: LintOptions) -> int:
    """Lint the files that the options name, fix and report the findings, and return the exit status."""
    began = _began(options)
    request = request_of(options)
    outputs = outputs_of(options.formats, options.output_file, FORMATS)
    fail_on = fail_on_of(options, request)
    print_messages(contradictions(request.config, options.distro))
    baseline = baseline_of(options, [request.config], request.selection, found_by="lint")
    if options.report is not None:
        from urdfctl.output.links import check_output

        check_output(options.report)
    if options.show_settings:
        from urdfctl.commands.find.shown_settings import settings_text

        print_text(settings_text(request, fail_on, options))
        return 0
    if options.fixes:
        from urdfctl.output.journal import restore_unfinished

        print_messages(restore_unfinished())
    run = _lint(request, outputs, is_cached=not (options.fixes or options.no_cache))
    if run.despite:
        print_message(
            f"checked although COLCON_IGNORE or CATKIN_IGNORE leaves nothing else: {', '.join(run.despite[:3])}"
        )

    def reported(run: LintRun) -> Report:
        made = report(run, request, fail_on=fail_on, unknown=baseline and baseline.unknown)
        made = made._replace(statistics=options.statistics, quiet=options.quiet, verbose=options.verbose)
        _deliver(made, outputs, options)
        if options.report is not None:
            _write_page(made, run, request, options.report, began)
        return made

    if options.fixes:
        return _fixed(run, request, options, outputs, reported)
    return _status(reported(run), run, options)


def _fixed(
    run: LintRun,
    request: LintRequest,
    options: LintOptions,
    outputs: Outputs,
    reported: Callable[[LintRun], Report],
) -> int:
    """Fix what a run found, or show how; report what is left, and return the exit status."""
    from urdfctl.commands.find.fixing import fix, report_fixes

    done = fix(run, request, unsafe=options.unsafe_fixes, as_diff=options.diff)
    after = _lint(request, outputs) if done.files and not options.diff else run
    if not options.diff:
        done = done._replace(left=tuple(after.results))
    made = reported(after)
    report_fixes(done, run.results, request, unsafe=options.unsafe_fixes, as_diff=options.diff)
    if options.diff:
        return 3 if run.crashed else int(done.files > 0 and not options.exit_zero)
    return 2 if done.failed else _status(made, after, options)


def _began(options: LintOptions) -> float:
    """When the run started, as time.monotonic() tells it, for its page."""
    if options.report is None:
        return 0.0
    if not options.report:
        raise UserError("--report requires the name of a file")
    import time

    return time.monotonic()


def request_of(options: LintOptions) -> LintRequest:
    """Return what is to be linted, with what the configuration and the environment add to the options."""
    check_jobs(options.jobs)
    paths, arguments = split_arguments(options.paths)
    config = configured(options.paths, options)
    settings = settings_to_check(config, options, paths)
    if options.node:
        from urdfctl.config.definitions import node_definitions

        settings = settings._replace(nodes=node_definitions(options.node))
    if options.shard is not None and options.write_baseline is not None:
        raise UserError("--write-baseline requires the whole run and cannot be used with --shard")
    given = Selection(codes(options.select), codes(options.ignore), codes(options.extend_select))
    return LintRequest(
        paths=tuple(paths),
        config=config,
        settings=settings,
        selection=selection_with(config, given),
        arguments=tuple(arguments.items()),
        shard=shard_of(options.shard),
        parallel=options.jobs or None,
    )


def fail_on_of(options: LintOptions, request: LintRequest) -> Severity:
    """Return the least severity that fails a run."""
    return severity_named(options.fail_on or request.config.fail_on or "error")


def _lint(request: LintRequest, outputs: Outputs, *, is_cached: bool = False) -> LintRun:
    """Lint, and import what will write the reports while the workers are busy."""

    def import_reports() -> None:
        for name, _ in outputs:
            module_of(name)

    return lint(request, watch=with_progress, meanwhile=import_reports, is_cached=is_cached)


def _status(report: Report, run: LintRun, options: LintOptions) -> int:
    if run.crashed:
        return 3
    severity = worst(report.findings)
    return int(severity is not None and severity.weight >= report.fail_on.weight and not options.exit_zero)


def _deliver(report: Report, outputs: Outputs, options: LintOptions) -> None:
    """Write the reports. With --diff, standard output is only for the diff."""
    if report.missing_packages and not options.quiet and all(name == "concise" for name, _ in outputs):
        print_message(about_missing_packages(report.missing_packages))
    for name, file in outputs:
        if file is not None or not options.diff:
            _write(report, name, file)


def _write(report: Report, name: str, file: str | None) -> None:
    if file is not None:
        write_file(file, render(report, name), force=True)
    elif name == "text" and is_coloured():
        from urdfctl.report.text import print_coloured

        print_coloured(report)
    else:
        print_text(render(report, name))


def _write_page(report: Report, run: LintRun, request: LintRequest, path: str, began: float) -> None:
    from urdfctl.page.writing import write_lint_page

    robots = {id(result) for result in run.robots}
    pairs = [pair for pair in run.targets if id(pair[1]) in robots]
    write_lint_page(path, report, pairs, request.settings, began=began, watch=with_progress)


command = Command(LintOptions, run_lint)
