"""`urdfctl lint`."""

from __future__ import annotations

import os
import sys

from urdfctl.cli.looking import LookedAt, found_by, look_at
from urdfctl.cli.wanted import Fixing, Wanted, found_in
from urdfctl.cli.words import codes, configured, output_of, settings_from, split_arguments
from urdfctl.cli.writing import print_text, tell, write_file
from urdfctl.config import Config
from urdfctl.diagnostic import Severity
from urdfctl.errors import UserError
from urdfctl.hints import TYPE_CHECKING
from urdfctl.lint import Selection, worst
from urdfctl.lint import checked as checked_selection
from urdfctl.report import FORMATS, render
from urdfctl.report.common import Report
from urdfctl.settings import Settings

if TYPE_CHECKING:
    from urdfctl.cli.known_findings import Baseline
    from urdfctl.shards import Shard


def lint_words(  # noqa: PLR0913, PLR0917 (one for each option)
    paths: list[str] | None = None,
    distro: str | None = None,
    simulator: str | None = None,
    start: str | None = None,
    workspace: str | None = None,
    package_path: list[str] | None = None,
    env: list[str] | None = None,
    trust: bool = False,  # noqa: FBT001, FBT002
    timeout: float = 20.0,
    memory: int = 2048,
    select: list[str] | None = None,
    ignore: list[str] | None = None,
    extend_select: list[str] | None = None,
    formats: list[str] | None = None,
    fail_on: str | None = None,
    baseline: str | None = None,
    write_baseline: str | None = None,
    statistics: bool = False,  # noqa: FBT001, FBT002
    exit_zero: bool = False,  # noqa: FBT001, FBT002
    shard: str | None = None,
    jobs: int = 0,
    config: str | None = None,
    show_settings: bool = False,  # noqa: FBT001, FBT002
    fix: bool = False,  # noqa: FBT001, FBT002
    unsafe_fixes: bool = False,  # noqa: FBT001, FBT002
    diff: bool = False,  # noqa: FBT001, FBT002
) -> int:
    """Lint with the options of the command line, report it, and give the exit status."""
    given = dict(locals())
    if jobs < 0:
        raise UserError(f"--jobs is a number of robots, or 0 for as many as there are processors; not {jobs}")
    chosen = configured(paths, config, workspace)
    settings = settings_from(chosen, distro, simulator, start, workspace, package_path, env, trust, timeout, memory)
    wanted = Wanted(
        tuple(paths or ()),
        _selection(chosen, codes(select), codes(ignore), codes(extend_select)),
        tuple(output_of(text, FORMATS) for text in formats or ("text",)),
        _severity(fail_on or chosen.fail_on or "error"),
        exit_zero,
        jobs,
        chosen,
        _baseline(baseline, write_baseline),
        statistics,
        Fixing(unsafe_fixes, diff) if fix or unsafe_fixes or diff else None,
        _shard(shard, write_baseline),
    )
    if show_settings:
        from urdfctl.cli.shown_settings import shown

        print_text(shown(wanted, settings, given))
        return 0
    return run_lint(wanted, settings)


def run_lint(wanted: Wanted, settings: Settings) -> int:
    """Lint what the words mean, report it, and give the exit status."""
    paths, arguments = split_arguments(wanted.words)
    found = found_by(paths, wanted.config)
    if not (found.descriptions() or found.controllers or found.launches or found.controllers_candidates):
        tell(f"no robot found in {', '.join(paths) or 'this folder'}")
    looked_at = look_at(found, tuple(arguments.items()), settings, wanted)
    if wanted.fixing is None:
        return _status(_report(looked_at, wanted), looked_at, wanted)
    from urdfctl.cli.fix_command import fix, tell_of

    done, before = fix(looked_at.all, settings, wanted, wanted.fixing), looked_at
    if wanted.fixing.as_diff:
        _report(looked_at, wanted)
        tell_of(done.files, before.linted, done.left, wanted, wanted.fixing)
        return 3 if looked_at.crashed else int(done.files > 0 and not wanted.exit_zero)
    looked_at = look_at(found, tuple(arguments.items()), settings, wanted) if done.files else before
    report = _report(looked_at, wanted)
    tell_of(done.files, before.linted, looked_at.linted, wanted, wanted.fixing)
    return 2 if done.failed else _status(report, looked_at, wanted)


def _status(report: Report, looked_at: LookedAt, wanted: Wanted) -> int:
    if looked_at.crashed:
        return 3
    gravest = worst(report.findings)
    return int(gravest is not None and gravest.weight >= wanted.fail_on.weight and not wanted.exit_zero)


def _report(looked_at: LookedAt, wanted: Wanted) -> Report:
    """The report, told as is wanted; on standard output stands the diff, where one is shown."""
    findings = found_in(looked_at.linted, wanted)
    told = findings
    if wanted.baseline is not None:
        read = {file for linted in looked_at.linted for file in linted.files}
        told = wanted.baseline.unknown(findings, read, wanted.selection)
    others, known = len(looked_at.all) - len(looked_at.robots), len(findings) - len(told)
    report = Report(tuple(looked_at.robots), tuple(told), others, wanted.fail_on, known, wanted.statistics)
    for name, file in wanted.outputs:
        if file is not None or not (wanted.fixing and wanted.fixing.as_diff):
            _tell(report, name, file)
    return report


def _selection(config: Config, select: tuple[str, ...], ignore: tuple[str, ...], extend: tuple[str, ...]) -> Selection:
    """The rules that the options ask for, and where they say nothing the configuration."""
    ignored = (*config.ignore, *(code for _, codes in config.per_file_ignores for code in codes))
    of_config = Selection(config.select, ignored, config.extend_select, config.severities)
    try:
        checked_selection(of_config)
    except UserError as error:
        raise UserError(f"{config.file}: {error}" if config.file else str(error)) from None
    return checked_selection(
        Selection(select or config.select, ignore or config.ignore, extend or config.extend_select, config.severities)
    )


def _baseline(path: str | None, to_write: str | None) -> Baseline | None:
    if path is None and to_write is None:
        return None
    from urdfctl.cli.known_findings import opened

    return opened(path, to_write)


def _shard(text: str | None, to_write: str | None) -> Shard | None:
    if text is None:
        return None
    if to_write is not None:
        raise UserError("--write-baseline needs the whole run; --shard is a part of one")
    from urdfctl.shards import shard

    return shard(text)


def _severity(name: str) -> Severity:
    try:
        return Severity(name)
    except ValueError:
        raise UserError(f"--fail-on is one of error, warning, info; not '{name}'") from None


def _tell(report: Report, name: str, file: str | None) -> None:
    if file is not None:
        write_file(file, render(report, name), force=True)
    elif name == "text" and sys.stdout.isatty() and not os.environ.get("NO_COLOR"):
        from urdfctl.report.text import print_coloured

        print_coloured(report)
    else:
        print_text(render(report, name))
