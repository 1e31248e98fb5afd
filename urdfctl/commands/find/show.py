"""`urdfctl show`: what is started together, and what is left out."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfctl.commands.declaring import OUTPUT, Command, option
from urdfctl.commands.options import FORMAT, TEXT_OR_JSON, CheckOptions
from urdfctl.commands.robot_targets import run_of
from urdfctl.commands.words import check_jobs, configured, output_of, settings_to_check, shard_of, split_arguments
from urdfctl.errors import UserError
from urdfctl.lint.judging import LintRun
from urdfctl.lint.results import TargetResult
from urdfctl.load.bringup import Bringup
from urdfctl.output.printing import print_text, visible
from urdfctl.output.writing import write_file
from urdfctl.report.common import as_json, is_robot, shown
from urdfctl.report.json_report import target_document, unjoined_document
from urdfctl.report.words import what_it_starts

_WIDTH = 12


class ShowOptions(CheckOptions):
    """Show what is started together: launch files with their robots, arguments and controllers; and unused files.

    \b
    Example: urdfctl show .
    """

    formats: tuple[str, ...] = option(OUTPUT, FORMAT, "--format", choices=TEXT_OR_JSON)


def run_show(options: ShowOptions) -> int:
    """Print what is started together, and return the exit status: 0, or 2 if there is nothing to show."""
    check_jobs(options.jobs)
    words = options.paths
    config = configured(words, options)
    paths, _ = split_arguments(words)
    settings = settings_to_check(config, options, paths)
    outputs = [output_of(text, TEXT_OR_JSON) for text in options.formats or ("text",)]
    run = run_of(words, config, settings, shard=shard_of(options.shard), parallel=options.jobs or None)
    if not run.targets and not run.unjoined and options.shard is None:
        where = ", ".join(paths) or "this folder"
        raise UserError(f"no robot, no controller file and no launch file that starts either in {where}")
    for name, file in outputs:
        text = _json(run) if name == "json" else "".join(f"{visible(line)}\n" for line in _lines(run))
        if file is not None:
            write_file(file, text, force=True)
        else:
            print_text(text)
    return 0


def _json(run: LintRun) -> str:
    targets = [target_document(target) for target in _started(run)]
    unused = [shown(one.path) for one in run.unused]
    unjoined = [unjoined_document(each) for each in run.unjoined]
    covered = [{"launch": shown(path), "by": shown(whole)} for path, whole in run.covered]
    document = {"version": 1, "targets": targets, "covered": covered, "unjoined": unjoined, "unused": unused}
    return as_json(document, 1) + "\n"


def _lines(run: LintRun) -> Iterator[str]:
    """A tree: launch files with what they start, then robots that no launch file starts, then what was not joined, and
    unused files."""
    started = _started(run)
    launched = {os.path.abspath(target.path) for target in started if target.launch}
    for target in sorted(started, key=lambda target: (target.launch is None, target.launch or "", target.path)):
        how = "it with these arguments" if os.path.abspath(target.path) in launched else "it"
        yield shown(target.launch) if target.launch else f"{_described(target)}  (no launch file starts {how})"
        yield from (f"  {name:{_WIDTH}}{value}" for name, value in _facts(target) if value)
    for path, whole in run.covered:
        yield f"{shown(path)}  ({shown(whole)} spawns its controllers)"
    for unjoined in run.unjoined:
        yield f"{shown(unjoined.path)}  (starts {what_it_starts(unjoined)})"
    for target in run.unused:
        yield f"{shown(target.path)}  (no robot uses it)"


def _started(run: LintRun) -> list[TargetResult]:
    """The robots of a run, and those that lint need not mention: launch files start them without controllers."""
    silent = {(target.path, target.arguments) for target in run.silent}
    alone = [target for target in run.robots if target.launch or (target.path, target.arguments) not in silent]
    return [*alone, *run.silent]


def _facts(target: TargetResult) -> Iterator[tuple[str, str]]:
    bringup = target.bringup or Bringup()
    yield "arguments", _arguments(bringup)
    if target.launch and is_robot(target):
        yield "description", _described(target)
    yield "beside", ", ".join(map(shown, bringup.beside))
    yield "namespace", bringup.namespace or ""
    yield "controllers", ", ".join(map(shown, target.controllers))
    yield "spawned", ", ".join(bringup.spawned)
    yield "includes", ", ".join(map(shown, bringup.includes))
    yield "moveit", "move_group" if bringup.moveit else ""
    yield "simulator", target.started_simulator or ", ".join(bringup.simulators)
    distro = target.distro or (f"ROS {target.ros}" if target.ros else "unknown")
    yield "distro", f"{distro}, from {target.distro_from}" if target.distro_from else distro
    yield "unknown", _unknown(bringup)
    if not target.complete:
        yield "incomplete", "not all of the description is known"


def _unknown(bringup: Bringup) -> str:
    """What a launch file starts or loads, and that is not here."""
    absent = [("launch files", bringup.absent if not bringup.complete else ()), ("parameter files", bringup.unloaded)]
    named = [f"{what} of {', '.join(packages)}" for what, packages in absent if packages]
    if named:
        return f"{' and '.join(named)}, not in this workspace"
    if not bringup.complete:
        return "some of what the launch file starts could not be determined"
    return "" if bringup.loads_known else "some parameter files that the launch file loads could not be determined"


def _arguments(bringup: Bringup) -> str:
    words = " ".join(f"{name}:={value}" for name, value in bringup.arguments)
    return f"{words or 'none'}  (as in {shown(bringup.told_at)})" if bringup.told_at else words


def _described(target: TargetResult) -> str:
    words = [shown(target.path), *(f"{name}:={value}" for name, value in target.arguments)]
    return " ".join(words).replace(os.sep, "/")


command = Command(ShowOptions, run_show)
