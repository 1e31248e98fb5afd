"""`urdfctl lint`."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.cli.lint_request import Fixing, LintRequest, Page
from urdfctl.cli.lint_run import lint_files
from urdfctl.cli.targets import discovered
from urdfctl.cli.words import (
    baseline_of,
    check_jobs,
    codes,
    configured,
    outputs_of,
    settings_to_check,
    severity_named,
    split_arguments,
)
from urdfctl.cli.writing import is_coloured, print_message, print_text, write_file
from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic
from urdfctl.errors import UserError
from urdfctl.lint.files import LintRun
from urdfctl.lint.grouping import grouped
from urdfctl.lint.merging import worst
from urdfctl.lint.selection import Selection, selection_with
from urdfctl.report import FORMATS, render
from urdfctl.report.common import Report, about_missing_packages
from urdfctl.startup.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfctl.cli.cache import RunCache
    from urdfctl.cli.options import LintOptions
    from urdfctl.discover.shards import Shard
    from urdfctl.lint.results import TargetResult


def run_lint(options: LintOptions) -> int:
    """Lint the files that the options name, report the findings, and return the exit status."""
    check_jobs(options.jobs)
    words = options.paths or []
    config = configured(words, options)
    settings = settings_to_check(config, options, split_arguments(words)[0])
    if options.node:
        from urdfctl.cli.node_definitions import node_definitions

        settings = settings._replace(nodes=node_definitions(options.node))
    request = _request(words, config, options)
    if options.report is not None:
        request = request._replace(page=_page(options.report, settings))
    if options.show_settings:
        from urdfctl.cli.shown_settings import settings_text

        print_text(settings_text(request, settings, vars(options)))
        return 0
    return lint(request, settings)


def _page(path: str, settings: Settings) -> Page:
    import time

    if not path:
        raise UserError("--report requires the name of a file")
    return Page(path, settings, time.monotonic())


def findings_in(options: LintOptions) -> list[Diagnostic]:
    """Return the findings in the files that the options name. Raises UserError if there is nothing to lint."""
    paths, arguments = split_arguments(options.paths or [])
    config = configured(paths, options)
    request = _request(paths, config, options)
    files = discovered(paths, config)
    if not files.paths():
        raise UserError(f"nothing to lint in {', '.join(paths)}: it contains no robot, controller file or launch file")
    run = lint_files(files, tuple(arguments.items()), settings_to_check(config, options, paths), request)
    return request.findings(run.results)


def _request(words: Sequence[str], config: Config, options: LintOptions) -> LintRequest:
    fixes = options.fix or options.unsafe_fixes or options.diff
    return LintRequest(
        words=tuple(words),
        selection=_selection(config, options),
        outputs=outputs_of(options.formats, options.output_file, FORMATS),
        fail_on=severity_named(options.fail_on or config.fail_on or "error"),
        exit_zero=options.exit_zero,
        jobs=options.jobs,
        config=config,
        baseline=baseline_of(options.baseline, options.write_baseline),
        statistics=options.statistics,
        fixing=Fixing(options.unsafe_fixes, options.diff) if fixes else None,
        shard=_shard(options.shard, options.write_baseline),
        cached=not options.no_cache,
        quiet=options.quiet,
    )


def lint(request: LintRequest, settings: Settings) -> int:
    """Lint, fix and report the files of a request, and return the exit status."""
    if request.fixing is not None:
        from urdfctl.cli.journal import restore_unfinished

        restore_unfinished()
    paths, named_arguments = split_arguments(request.words)
    arguments = tuple(named_arguments.items())
    cache = _cache(paths, settings, request)
    known = cache.load() if cache else None
    if known is not None:
        results, positions = known
        run = LintRun([result for index, (_, result) in enumerate(results) if index in positions], results)
        return _status(_report(run, request), run, request)
    files = discovered(paths, request.config)
    if not files.paths():
        raise UserError(
            f"nothing to lint in {', '.join(paths) or 'this folder'}: name a robot (.urdf, .xacro), a controller file "
            "(.yaml) or a launch file, or a folder that contains one"
        )
    if files.despite:
        print_message(
            f"checked although COLCON_IGNORE or CATKIN_IGNORE leaves nothing else: {', '.join(files.despite[:3])}"
        )
    run = lint_files(files, arguments, settings, request)
    if not run.results and request.shard is None:
        raise UserError(
            f"nothing to lint in {', '.join(paths) or 'this folder'}: it contains launch files, but they start no "
            "robot or controllers of this workspace"
        )
    if cache:
        robots = {id(result) for result in run.robots}
        cache.store(run.targets, (index for index, (_, result) in enumerate(run.targets) if id(result) in robots))
    if settings.nodes:
        from urdfctl.cli.node_definitions import check_nodes

        check_nodes(settings.nodes, run.results)
    if request.fixing is None:
        return _status(_report(run, request), run, request)
    from urdfctl.cli.fix_command import fix, report_fixes

    done, before = fix(run.targets, settings, request, request.fixing), run
    if request.fixing.as_diff:
        _report(run, request)
        report_fixes(done.files, before.results, done.left, request, request.fixing)
        return 3 if run.crashed else int(done.files > 0 and not request.exit_zero)
    run = lint_files(files, arguments, settings, request) if done.files else before
    report = _report(run, request)
    report_fixes(done.files, before.results, run.results, request, request.fixing)
    return 2 if done.failed else _status(report, run, request)


def _cache(paths: Sequence[str], settings: Settings, request: LintRequest) -> RunCache | None:
    """The cache of a run that fixes nothing."""
    if request.fixing is not None or not request.cached:
        return None
    from urdfctl.cli.cache import RunCache

    asked = (request.words, request.selection, request.config, request.shard)
    return RunCache(paths, settings, asked, extra=[request.config.file] if request.config.file else ())


def _status(report: Report, run: LintRun, request: LintRequest) -> int:
    if run.crashed:
        return 3
    severity = worst(report.findings)
    return int(severity is not None and severity.weight >= request.fail_on.weight and not request.exit_zero)


def _report(run: LintRun, request: LintRequest) -> Report:
    """Write the reports. With --diff, standard output is only for the diff."""
    findings = request.findings(run.results)
    shown = findings
    if request.baseline is not None:
        read = {file for result in run.results for file in result.files}
        shown = request.baseline.unknown(findings, read, request.selection)
    unused, known = tuple(result.path for result in run.unused), len(findings) - len(shown)
    report = Report(
        targets=tuple(run.robots),
        findings=tuple(grouped(shown)),
        unused=unused,
        fail_on=request.fail_on,
        known=known,
        statistics=request.statistics,
        missing_packages=tuple(sorted({name for result in run.results for name in result.missing_packages})),
        quiet=request.quiet,
        uncontrolled=_uncontrolled(run.robots),
    )
    if report.missing_packages and not request.quiet and all(name == "concise" for name, _ in request.outputs):
        print_message(about_missing_packages(report.missing_packages))
    for name, file in request.outputs:
        if file is not None or not (request.fixing and request.fixing.as_diff):
            _write(report, name, file)
    if request.page is not None:
        from urdfctl.cli.run_page import write_lint_page

        robots = {id(result) for result in run.robots}
        pairs = [pair for pair in run.targets if id(pair[1]) in robots]
        write_lint_page(request.page.path, report, pairs, request.page.settings, request.page.began)
    return report


def _uncontrolled(robots: Sequence[TargetResult]) -> str:
    """The path of the first robot if nothing of any robot is controlled."""
    whole = [result for result in robots if result.links]
    return whole[0].path if whole and all(result.idle for result in whole) else ""


def _selection(config: Config, options: LintOptions) -> Selection:
    """Return the rules that the options select, by default those that the configuration selects."""
    given = Selection(codes(options.select), codes(options.ignore), codes(options.extend_select))
    return selection_with(config, given)


def _shard(text: str | None, to_write: str | None) -> Shard | None:
    if text is None:
        return None
    if to_write is not None:
        raise UserError("--write-baseline requires the whole run and cannot be used with --shard")
    from urdfctl.discover.shards import shard

    return shard(text)


def _write(report: Report, name: str, file: str | None) -> None:
    if file is not None:
        write_file(file, render(report, name), force=True)
    elif name == "text" and is_coloured():
        from urdfctl.report.text import print_coloured

        print_coloured(report)
    else:
        print_text(render(report, name))
