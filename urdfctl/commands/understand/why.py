"""`urdfctl why`: where a value comes from, and what uses it."""

from __future__ import annotations

import os
from typing import Any

from urdfctl.commands.declaring import OUTPUT, Command, argument, option
from urdfctl.commands.options import TEXT_OR_JSON, TargetOptions
from urdfctl.commands.robot_targets import best_of, robots_of
from urdfctl.commands.words import configured, output_of, settings_from, split_arguments
from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.load.target import Target
from urdfctl.output.printing import print_text
from urdfctl.output.writing import write_file
from urdfctl.report.common import as_json, shown
from urdfctl.source.workspaces.packages import package_around
from urdfctl.trace.address import HOW, LineAddress, line_named
from urdfctl.trace.job import why
from urdfctl.trace.text import render


class WhyOptions(TargetOptions):
    """Show where a value of a robot comes from, and what uses it.

    \b
    Example: urdfctl why urdf/robot.xacro joint:elbow/limit/@velocity reach:=0.6
             urdfctl why config/joint_limits.yaml:26
    """

    words: tuple[str, ...] = argument(
        "The robot (or its launch file) and a value in it, such as joint:NAME/limit/@velocity; or the place "
        "FILE:LINE[:COL] of a value; and name:=value arguments.",
        metavar="[ROBOT] VALUE [NAME:=VALUE]...",
        is_required=True,
    )
    output_format: str = option(
        OUTPUT,
        "Output format: text or json. FORMAT=FILE writes a file.",
        "--format",
        default="text",
        choices=TEXT_OR_JSON,
    )


def run_why(options: WhyOptions) -> int:
    """Print where a value comes from, and return the exit status 0."""
    paths, arguments = split_arguments(options.words)
    output, file = output_of(options.output_format, TEXT_OR_JSON)
    if len(paths) not in {1, 2}:
        raise UserError(f"why needs one robot and one value: urdfctl why robot.xacro VALUE; {HOW}")
    what = line_named(paths[-1])
    if what is None and len(paths) == 1:
        raise UserError(f"why needs a value: urdfctl why {paths[0]} VALUE; {HOW}")
    config = configured(paths[: len(paths) - 1] or [os.path.dirname(paths[0]) or os.curdir], options)
    settings = settings_from(config, options, distro=options.distro, simulator=options.simulator, named=paths[:1])
    given = [f"{name}:={value}" for name, value in arguments.items()]
    target = _named(paths[0], given, config, settings) if len(paths) > 1 else _around(what, given, config, settings)
    answer = why(target, settings, what or paths[-1])
    text = as_json(answer, 1) + "\n" if output == "json" else render(answer)
    if file is not None:
        write_file(file, text, force=True)
    else:
        print_text(text)
    return 0


def _named(path: str, given: list[str], config: Config, settings: Settings) -> Target:
    """The robot that the user names, as it is launched."""
    found = best_of(robots_of([path, *given], config, settings))
    return found[0] if found else Target(path, tuple(split_arguments(given)[1].items()))


def _around(line: Any, given: list[str], config: Config, settings: Settings) -> Target:
    """The robot that a file is read for: itself, or one of its package."""
    assert isinstance(line, LineAddress)  # noqa: S101 (for mypy)
    folder = package_around(os.path.dirname(line.file)) or os.path.dirname(line.file)
    for word in (line.file, folder):
        found = best_of(robots_of([word, *given], config, settings), lambda result: line.file in result.files)
        if found is not None and found[1].links:
            return found[0]
    file = shown(line.file)
    how = (
        f"name the robot, and the arguments with which it does: urdfctl why robot.xacro {file}:{line.line} NAME:=VALUE"
    )
    raise UserError(f"no robot reads '{file}'; {how}")


command = Command(WhyOptions, run_why)
