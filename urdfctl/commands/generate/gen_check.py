"""`urdfctl gen-check`."""

from __future__ import annotations

from urdfctl.commands.declaring import OUTPUT, Command, Options, argument, option
from urdfctl.commands.running import run_words
from urdfctl.generate.files.again import run_again


class CheckGeneratedOptions(Options):
    """Run the command in the first lines of each generated file again; exit with status 1 if one is out of date.

    \b
    Example: urdfctl gen-check config urdf launch
    """

    paths: tuple[str, ...] = argument("Files and folders to search. Default: this folder.")
    update: bool = option(OUTPUT, "Write the files that are out of date.")


def run_check(options: CheckGeneratedOptions) -> int:
    """Check or update generated files, and return the exit status."""
    return run_again(options.paths, run_words, update=options.update)


command = Command(CheckGeneratedOptions, run_check)
