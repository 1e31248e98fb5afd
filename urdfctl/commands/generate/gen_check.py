"""`urdfctl gen-check`."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.commands import command_named
from urdfctl.commands.answering import AnswerOptions, answered
from urdfctl.commands.declaring import OUTPUT, Command, argument, option
from urdfctl.commands.generate.options import GenerateOptions
from urdfctl.commands.generate.running import generate
from urdfctl.commands.reach import within_reach
from urdfctl.commands.reading import plain_options
from urdfctl.errors import UserError
from urdfctl.generate.files.again import run_again
from urdfctl.output.answer import CommandAnswer


class CheckGeneratedOptions(AnswerOptions):
    """Run the command in the first lines of each generated file again; exit with status 1 if one is out of date.

    \b
    Example: urdfctl gen-check config urdf launch
    """

    paths: tuple[str, ...] = argument("Files and folders to search. Default: this folder.")
    update: bool = option(OUTPUT, "Write the files that are out of date.")


def run_check(options: CheckGeneratedOptions) -> int:
    """Check or update generated files, and return the exit status."""
    return answered(
        "gen-check", options, lambda answer: run_again(options.paths, _generate, answer, update=options.update)
    )


def _generate(words: Sequence[str], answer: CommandAnswer) -> int:
    """Run the command line of a generator, and return its exit status."""
    options = plain_options(command_named(words[0]).options, words[1:])
    if not isinstance(options, GenerateOptions):
        raise UserError(f"its command cannot be read: urdfctl {' '.join(words)}")
    with within_reach(options):
        return generate(options, answer)


command = Command(CheckGeneratedOptions, run_check)
