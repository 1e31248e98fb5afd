"""Run a command line."""

from __future__ import annotations

import gc
from collections.abc import Sequence

from urdfctl.commands import COMMANDS, command_named
from urdfctl.commands.reach import run_command
from urdfctl.commands.reading import plain_options


def run_words(words: Sequence[str]) -> int:
    """Run a command line, given without the program's name, and return the exit status."""
    is_known = bool(words) and words[0] in COMMANDS
    if not (is_known and COMMANDS[words[0]].is_short):
        gc.enable()
    if is_known:
        command = command_named(words[0])
        options = plain_options(command.options, words[1:])
        if options is not None:
            return run_command(command, options)
    from urdfctl.commands.app import run_by_typer

    return run_by_typer(words)
