"""`urdfctl smoke`."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterable, Iterator, Sequence

from urdfctl.commands.declaring import CHECKED_FOR, CONTROLLERS, EXIT, LIMITS, OUTPUT, RULES, Command, Reads, option
from urdfctl.commands.options import FORMAT, CheckOptions, ReportOptions
from urdfctl.commands.progress import with_progress
from urdfctl.commands.words import (
    baseline_of,
    check_jobs,
    codes,
    configurations,
    outputs_of,
    settings_to_check,
    severity_named,
    shard_of,
    split_arguments,
)
from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Severity
from urdfctl.errors import UserError
from urdfctl.lint.findings.merging import worst
from urdfctl.lint.selection import Selection, validate_selection
from urdfctl.names import nearest_path
from urdfctl.output.links import check_output
from urdfctl.output.printing import is_coloured, is_watched, print_text
from urdfctl.output.writing import write_file
from urdfctl.smoke.curves import curves_as_csv
from urdfctl.smoke.engines import CHOICES, engines_named, installed
from urdfctl.smoke.reports import SMOKE_FORMATS, SmokeReport, render_smoke, text_pieces
from urdfctl.smoke.run import ConfiguredPaths, RobotTest, SmokeRequest, report, smoke
from urdfctl.smoke.tasks import read_tasks

NOTHING_TESTED = 5
"""Exit status if no controller was taken through its life."""
INTERRUPTED = 130
"""Exit status after Ctrl-C, as of a program that the signal ends; what was tested until then is reported."""
MAX_DURATION = 60.0
"""Seconds of simulation for one controller."""

_MOCK = "mock"
_REAL = "ros2"
"""The engine that is no physics engine: the controller manager of a sourced ROS 2."""


class SmokeOptions(CheckOptions, ReportOptions, command="smoke"):
    """Spawn robots without ROS, then load, activate and move each of their controllers.

    \b
    Example: urdfctl smoke urdf/robot.xacro --controllers config/controllers.yaml
    """

    controllers: tuple[str, ...] = option(
        CONTROLLERS, "Controller file that belongs to each robot.", metavar="FILE", reads=Reads.PLACE
    )
    only: tuple[str, ...] = option(
        CHECKED_FOR, "Test only the controllers with these names: NAME,NAME.", metavar="NAME,..."
    )
    engine: str = option(
        CHECKED_FOR,
        "Physics engine: auto, pybullet, mujoco, both, or none to move nothing; ros2: the real controller manager.",
        default="auto",
        choices=(*CHOICES, _REAL),
    )
    hardware: str | None = option(
        CHECKED_FOR,
        "mock: test with mock hardware where the robot's driver is not in the files, or cannot be started.",
        choices=(_MOCK,),
        of=("smoke",),
    )
    tasks: str | None = option(
        CHECKED_FOR,
        "YAML file with your own targets, trajectories, tolerances and start pose.",
        metavar="FILE",
        reads=Reads.PLACE,
    )
    duration: float = option(CHECKED_FOR, "Seconds of simulation for each controller.", default=2.0, metavar="SECONDS")
    progress: bool | None = option(
        OUTPUT,
        "Print a line on standard error for each controller that was simulated. Default: on terminals.",
    )
    csv: str | None = option(
        OUTPUT,
        "Write what was commanded and measured to this file, a line for each joint and time.",
        metavar="FILE",
        reads=Reads.TARGET,
    )
    video: str | None = option(
        OUTPUT,
        "Write the motions as a film to this file, .gif or .mp4.",
        metavar="FILE",
        reads=Reads.TARGET,
        of=("smoke",),
    )
    gui: bool = option(CHECKED_FOR, "Show pybullet's window.", of=("smoke",))
    timeout: float = option(LIMITS, "Processor time for one robot, in seconds.", default=30.0, metavar="SECONDS")
    formats: tuple[str, ...] = option(OUTPUT, FORMAT, "--format", choices=tuple(SMOKE_FORMATS))
    select: tuple[str, ...] = option(RULES, "Select findings by code or prefix, e.g. UC91,UC931.", metavar="CODE,...")
    ignore: tuple[str, ...] = option(RULES, "Ignore findings by code or prefix.", metavar="CODE,...")
    allow_empty: bool = option(EXIT, "Exit with status 0, not 5, if there is no controller to test.", of=("smoke",))


def run_smoke(options: SmokeOptions) -> int:
    """Test the robots that the options name, report the results, and return the exit status."""
    began = time.monotonic()
    _validate(options)
    outputs = outputs_of(options.formats, options.output_file, SMOKE_FORMATS)
    if options.engine == _REAL:
        from urdfctl.commands.find.real_smoke import tested_by_ros2

        return tested_by_ros2(tested(options, with_progress_of_tests)[0], outputs)
    tests, made = tested(options, with_progress_of_tests)
    for name, file in outputs:
        write_smoke(made, name, file)
    if options.csv:
        write_file(options.csv, curves_as_csv(made.robots), force=True)
    robots = [(test.settings, test.target) for test in tests]
    if options.video:
        from urdfctl.page.writing import write_film

        write_film(options.video, list(zip(robots, made.robots, strict=True)), watch=with_progress)
    if options.report:
        from urdfctl.page.writing import write_smoke_page

        write_smoke_page(
            options.report, made, list(zip(robots, made.robots, strict=True)), began=began, watch=with_progress
        )
    return smoke_status(made, exit_zero=options.exit_zero)


def with_progress_of_tests(tests: Iterator[RobotTest], total: int) -> Iterable[RobotTest]:
    """Yield tests, and show on a terminal how many of them are done."""
    return with_progress(tests, total, "testing")


def tested(
    options: SmokeOptions, watch: Callable[[Iterator[RobotTest], int], Iterable[RobotTest]]
) -> tuple[list[RobotTest], SmokeReport]:
    """Return the tests of the robots that the options name, and the report of them. watch: as in `smoke`."""
    _validate(options)
    given = configurations(options.paths, options)
    groups = [ConfiguredPaths(tuple(paths), config, _settings(config, options)) for config, paths in given]
    selection = validate_selection(Selection(select=codes(options.select), ignore=codes(options.ignore)))
    fail_on = _fail_on(options, [group.config for group in groups])
    baseline = baseline_of(options, [group.config for group in groups], selection, found_by="smoke")
    tests = smoke(groups, _request(options), watch)
    made = report(tests, groups, selection, unknown=baseline and baseline.unknown, fail_on=fail_on)
    found = made.found._replace(quiet=options.quiet, verbose=options.verbose, statistics=options.statistics)
    return tests, made._replace(
        found=found,
        allow_empty=options.allow_empty or options.shard is not None,
    )


def _request(options: SmokeOptions) -> SmokeRequest:
    return SmokeRequest(
        only=tuple(name.strip() for text in options.only for name in text.split(",") if name.strip()),
        engines=() if options.engine == _REAL else engines_named(options.engine),
        instead=installed()[1:] if options.engine == "auto" else (),
        duration=options.duration,
        gui=options.gui,
        tasks=read_tasks(options.tasks) if options.tasks is not None else None,
        live=is_watched() if options.progress is None else options.progress,
        arguments=tuple(split_arguments(options.paths)[1].items()),
        controllers=options.controllers,
        mocked=options.hardware == _MOCK,
        shard=shard_of(options.shard),
        parallel=options.jobs or None,
    )


def smoke_status(made: SmokeReport, *, exit_zero: bool) -> int:
    """Return the exit status of a run: 3 after a crash, then whether it was interrupted, failed or tested nothing."""
    if any(robot.linted.outcome.crashed for robot in made.robots):
        return 3
    if made.is_interrupted:
        return INTERRUPTED
    if exit_zero:
        return 0
    severity = worst(made.found.findings)
    if severity is not None and severity.weight >= made.found.fail_on.weight:
        return 1
    return NOTHING_TESTED if made.is_empty else 0


def _validate(options: SmokeOptions) -> None:
    check_jobs(options.jobs)
    if not 0 < options.duration <= MAX_DURATION:
        raise UserError(f"--duration must be a number of seconds up to {MAX_DURATION:g}, not {options.duration:g}")
    if options.hardware not in (None, _MOCK):
        raise UserError(f"unknown hardware '{options.hardware}'; known is {_MOCK}")
    if options.report == "":
        raise UserError("--report requires the name of a file")
    check_output(options.report)
    if options.csv == "":
        raise UserError("--csv requires the name of a file")
    check_output(options.csv)
    for name, given in {"--csv": options.csv, "--video": options.video, "--tasks": options.tasks}.items():
        if given is not None and options.engine in ("none", _REAL):
            raise UserError(f"{name} requires a physics engine, not --engine {options.engine}")
    if options.video is not None:
        from urdfctl.page.film import check_film

        check_film(options.video)
        check_output(options.video)
    if "" in options.controllers:
        raise UserError("--controllers requires the name of a file")
    for path in options.controllers:
        if not os.path.lexists(path):
            raise UserError(f"file does not exist: '{path}'{nearest_path(path)}")


def _settings(config: Config, options: SmokeOptions) -> Settings:
    named = [*split_arguments(options.paths)[0], *options.controllers]
    return settings_to_check(config, options, named)


def _fail_on(options: SmokeOptions, configs: Sequence[Config]) -> Severity:
    """The least severity that fails the run: the option, or the least one of the configurations."""
    names = [options.fail_on] if options.fail_on else [config.fail_on or "error" for config in configs]
    return min(map(severity_named, names), key=lambda severity: severity.weight)


def write_smoke(report: SmokeReport, name: str, file: str | None) -> None:
    """Write or print a report in one of its formats."""
    if file is not None:
        write_file(file, render_smoke(report, name), force=True)
    elif name == "text" and is_coloured():
        from urdfctl.report.text import print_pieces

        print_pieces(text_pieces(report))
    else:
        print_text(render_smoke(report, name))


command = Command(SmokeOptions, run_smoke)
