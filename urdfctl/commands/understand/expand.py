"""`urdfctl expand`."""

from __future__ import annotations

import os
import sys

from urdfctl.commands.answering import AnswerOptions, answered
from urdfctl.commands.declaring import OUTPUT, Command, Reads, argument, option
from urdfctl.commands.options import ReadingOptions
from urdfctl.commands.words import configured, settings_from, split_arguments
from urdfctl.discover.paths import check_path
from urdfctl.errors import UserError
from urdfctl.expand.job import ExpandedText, expand_file
from urdfctl.lint.results import Report
from urdfctl.names import nearest_path
from urdfctl.output.answer import CommandAnswer, FileState
from urdfctl.output.links import check_output
from urdfctl.output.writing import would_overwrite, write_file
from urdfctl.report.common import relative
from urdfctl.report.json_report import finding
from urdfctl.report.text import render


class ExpandOptions(ReadingOptions, AnswerOptions):
    """Expand xacro without ROS, byte for byte as xacro does.

    \b
    Example: urdfctl expand urdf/robot.xacro reach:=0.6 -o robot.urdf
    """

    file: str = argument("The xacro file.", is_required=True)
    arguments: tuple[str, ...] = argument("name:=value", reads=Reads.NOTHING)
    output: str | None = option(OUTPUT, "Write to this file.", "-o", "--output", metavar="PATH", reads=Reads.TARGET)
    force: bool = option(OUTPUT, "Overwrite the output file.")


def run_expand(options: ExpandOptions) -> int:
    """Print or write the expanded file, and return the exit status.

    On an error, print the first problem to standard error; the status is 1.
    """
    return answered("expand", options, lambda answer: _expand(options, answer))


def _expand(options: ExpandOptions, answer: CommandAnswer) -> int:
    expanded = expansion(options)
    answer.add(findings=[finding(relative(problem)) for problem in expanded.problems])
    if not answer.is_kept:
        sys.stderr.write(render(Report((), expanded.problems, quiet=True)))
    if expanded.text is None:
        return 3 if expanded.crashed else 1
    if options.output is not None:
        write_file(options.output, expanded.text, force=options.force)
        answer.file(options.output, FileState.WRITTEN)
    else:
        answer.text(expanded.text)
    return 0


def expansion(options: ExpandOptions) -> ExpandedText:
    """Return what a file expands to. Raises UserError for bad options, also if the output may not be written."""
    file, output = options.file, options.output
    settings = settings_from(configured([file], options), options)
    paths, arguments = split_arguments(options.arguments)
    if paths:
        raise UserError(f"unexpected argument '{paths[0]}': expand reads one file; arguments are name:=value")
    if not os.path.lexists(file):
        check_path(file)
        raise UserError(f"file '{file}' does not exist{nearest_path(file)}")
    check_output(output)
    if output is not None and would_overwrite(output) and not options.force:
        raise UserError(f"'{output}' exists; --force overwrites it")
    return expand_file(file, arguments, settings)


command = Command(ExpandOptions, run_expand)
