"""`urdfctl smoke`."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator, Sequence

from urdfctl.cli.progress import with_progress
from urdfctl.cli.targets import discovered
from urdfctl.cli.words import (
    baseline_of,
    check_jobs,
    codes,
    configurations,
    outputs_of,
    settings_to_check,
    severity_named,
    split_arguments,
)
from urdfctl.cli.writing import is_coloured, print_text, write_file
from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Severity
from urdfctl.errors import UserError
from urdfctl.lint.merging import merge, worst
from urdfctl.lint.planning import PlannedTarget, of_shard, planned
from urdfctl.lint.selection import Selection, validate_selection
from urdfctl.load.target import Target
from urdfctl.names import did_you_mean, enumerated, nearest_path
from urdfctl.smoke.assignments import read_tasks
from urdfctl.smoke.engines import NAMES, installed
from urdfctl.smoke.job import Wanted, smoke_all
from urdfctl.smoke.reports import SMOKE_FORMATS, SmokeReport, render_smoke, report_of, text_pieces
from urdfctl.smoke.results import Smoked
from urdfctl.startup.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfctl.cli.options import SmokeOptions

NOTHING_TESTED = 5
"""Exit status if no controller was taken through its life."""
INTERRUPTED = 130
"""Exit status after Ctrl-C, as of a program that the signal ends; what was tested until then is reported."""
MAX_DURATION = 60.0
"""Seconds of simulation for one controller."""
ENGINES = ("auto", *NAMES, "both", "none")


def run_smoke(options: SmokeOptions) -> int:
    """Test the robots that the options name, report the results, and return the exit status."""
    began = time.monotonic()
    _validate(options)
    words = options.paths or []
    given = [(config, _settings(config, options), paths) for config, paths in configurations(words, options)]
    selection = validate_selection(Selection(select=codes(options.select), ignore=codes(options.ignore)))
    fail_on = _fail_on(options, [config for config, _, _ in given])
    baseline = baseline_of(options.baseline, options.write_baseline)
    outputs = outputs_of(options.formats, options.output_file, SMOKE_FORMATS)
    wanted = Wanted(
        only=tuple(name.strip() for text in options.only or () for name in text.split(",") if name.strip()),
        engines=engines_of(options.engine),
        instead=installed()[1:] if options.engine == "auto" else (),
        duration=options.duration,
        gui=options.gui,
        tasks=read_tasks(options.tasks) if options.tasks is not None else None,
        live=_is_terminal() if options.progress is None else options.progress,
    )
    arguments = tuple(split_arguments(words)[1].items())
    plans = [_plan(paths, arguments, config, options) for config, _, paths in given]
    plan = [entry for entries in plans for entry in entries]
    own = [settings for (_, settings, _), entries in zip(given, plans, strict=True) for _ in entries]
    if not plan and options.shard is None:
        where = ", ".join(split_arguments(words)[0]) or "this folder"
        raise UserError(f"nothing to test in {where}: name a robot or a launch file")
    kept: list[int] = []
    results = _results(plan, own, wanted, options.jobs, kept)
    smoked = list(with_progress(results, len(plan), "testing"))
    _check_only(wanted.only, smoked)
    outcomes = [robot.linted.outcome for robot in smoked]
    everything = merge(outcomes, Selection())
    findings = [
        finding
        for finding in everything
        if selection.admits(finding.code)
        and not any(config.ignores(finding.at.file, finding.code) for config, _, _ in given)
    ]
    if baseline is not None:
        files = {file for robot in smoked for file in robot.linted.files}
        findings = baseline.unknown(findings, files, selection)
    shown = {finding.message for finding in findings}
    hidden = [finding.message for finding in everything if finding.message not in shown]
    smoked = [robot.without(hidden) for robot in smoked]
    report = report_of(smoked, findings, fail_on)
    report = report._replace(found=report.found._replace(quiet=options.quiet, statistics=options.statistics))
    report = report._replace(allow_empty=options.allow_empty or options.shard is not None)
    for name, file in outputs:
        _write(report, name, file)
    if options.report:
        from urdfctl.cli.run_page import write_smoke_page

        robots = [(own[index], plan[index].target) for index in kept]
        write_smoke_page(options.report, report, list(zip(robots, smoked, strict=True)), began)
    if any(outcome.crashed for outcome in outcomes):
        return 3
    if report.is_interrupted:
        return INTERRUPTED
    return 0 if options.exit_zero else _status(report)


def _is_terminal() -> bool:
    return sys.stderr.isatty() and os.environ.get("TERM") != "dumb"


def _status(report: SmokeReport) -> int:
    severity = worst(report.found.findings)
    if severity is not None and severity.weight >= report.found.fail_on.weight:
        return 1
    return NOTHING_TESTED if report.is_empty else 0


def _check_only(only: Sequence[str], smoked: Sequence[Smoked]) -> None:
    names = {controller.name for robot in smoked for controller in robot.controllers}
    unknown = [name for name in only if name not in names]
    if unknown:
        quoted = enumerated([f"'{name}'" for name in unknown], "or")
        raise UserError(f"--only: no robot has a controller {quoted}")


def _validate(options: SmokeOptions) -> None:
    check_jobs(options.jobs)
    if not 0 < options.duration <= MAX_DURATION:
        raise UserError(f"--duration must be a number of seconds up to {MAX_DURATION:g}, not {options.duration:g}")
    if options.report == "":
        raise UserError("--report requires the name of a file")
    if options.tasks is not None and options.engine == "none":
        raise UserError("--tasks requires a physics engine, not --engine none")
    if "" in (options.controllers or ()):
        raise UserError("--controllers requires the name of a file")
    for path in options.controllers or ():
        if not os.path.lexists(path):
            raise UserError(f"file does not exist: '{path}'{nearest_path(path)}")


def _settings(config: Config, options: SmokeOptions) -> Settings:
    named = [*split_arguments(options.paths or [])[0], *(options.controllers or ())]
    return settings_to_check(config, options, named)


def _fail_on(options: SmokeOptions, configs: Sequence[Config]) -> Severity:
    """The least severity that fails the run: the option, or the least one of the configurations."""
    names = [options.fail_on] if options.fail_on else [config.fail_on or "error" for config in configs]
    return min(map(severity_named, names), key=lambda severity: severity.weight)


def _plan(
    paths: Sequence[str], arguments: tuple[tuple[str, str], ...], config: Config, options: SmokeOptions
) -> list[PlannedTarget]:
    files = discovered(paths, config)
    plan = planned(files, arguments, config.robots)
    if options.shard is not None:
        from urdfctl.discover.shards import shard

        _, plan = of_shard(files, plan, shard(options.shard), config.robots)
    return [entry._replace(target=_with_controllers(entry.target, options.controllers or ())) for entry in plan]


def _results(
    plan: Sequence[PlannedTarget], own: Sequence[Settings], wanted: Wanted, jobs: int, kept: list[int]
) -> Iterator[Smoked]:
    """Yield the results to report; `kept` then holds their indices in the plan. own: the settings of each target."""

    def chosen(judged: list[Smoked]) -> list[int]:
        pairs = zip(judged, plan, strict=True)
        kept[:] = _reported([robot if entry.is_reported(robot.linted) else None for robot, entry in pairs])
        return kept

    return smoke_all([entry.target for entry in plan], own, wanted, jobs or None, chosen)


def _with_controllers(target: Target, controllers: Sequence[str]) -> Target:
    return target._replace(controllers=(*target.controllers, *controllers))


def _reported(smoked: list[Smoked | None]) -> Iterator[int]:
    """Yield the indices of the results to report. Each robot with its controllers is reported once, in whatever order
    launch files start them, unless they are rejected for another reason then. A robot without
    controllers is reported only if no launch file gives it any."""
    driven = {robot.linted.path for robot in smoked if robot and robot.controllers}
    seen = set()
    for index, robot in enumerate(smoked):
        if robot is None:
            continue
        verdicts = frozenset((result.name, result.verdict, result.reason) for result in robot.controllers)
        key = robot.linted.path, robot.linted.controllers, verdicts
        if key not in seen and (robot.controllers or robot.linted.path not in driven):
            seen.add(key)
            yield index


def engines_of(name: str) -> tuple[str, ...]:
    """Return the engines that a name means. UserError if there is no such engine, or it is not installed."""
    if name not in ENGINES:
        raise UserError(f"unknown engine '{name}'{did_you_mean(name, ENGINES)}; known are {', '.join(ENGINES)}")
    if name == "none":
        return ()
    available = installed()
    wanted = NAMES if name == "both" else available[:1] if name == "auto" else (name,)
    if not wanted or not set(wanted) <= set(available):
        missing = "no physics engine" if name == "auto" else "not every engine" if name == "both" else f"'{name}'"
        is_there = "is installed" if name in ("auto", "both") else "is not installed"
        raise UserError(
            f"{missing} {is_there}: pip install 'urdfctl[smoke]', or use --engine none to test without moving anything"
        )
    return wanted


def _write(report: SmokeReport, name: str, file: str | None) -> None:
    if file is not None:
        write_file(file, render_smoke(report, name), force=True)
    elif name == "text" and is_coloured():
        from urdfctl.report.text import print_pieces

        print_pieces(text_pieces(report))
    else:
        print_text(render_smoke(report, name))
