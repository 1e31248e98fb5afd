"""`urdfctl expand`."""

from __future__ import annotations

import os
import sys

from urdfctl.cli.words import split_arguments
from urdfctl.cli.writing import is_in_the_way, print_text, write_file
from urdfctl.errors import UserError
from urdfctl.expand import expand_one
from urdfctl.report.common import Report
from urdfctl.report.text import render
from urdfctl.settings import Settings
from urdfctl.suggest import nearest_path


def run_expand(file: str, words: list[str], settings: Settings, output: str | None, *, force: bool) -> int:
    """Print or write what xacro would; the first problem, with its place, on standard error and exit status 1."""
    paths, arguments = split_arguments(words)
    if paths:
        raise UserError(f"one file at a time: what is '{paths[0]}'? Arguments are written name:=value")
    if not os.path.lexists(file):
        raise UserError(f"no such file: '{file}'{nearest_path(file)}")
    if output is not None and is_in_the_way(output) and not force:
        raise UserError(f"'{output}' exists; --force overwrites it")
    expanded = expand_one(file, arguments, settings)
    if expanded.text is None:
        told = render(Report((), expanded.problems)).splitlines()
        sys.stderr.write("\n".join(told[:-1]) + "\n")
        return 3 if expanded.crashed else 1
    for warning in render(Report((), expanded.problems)).splitlines()[:-1]:
        sys.stderr.write(warning + "\n")
    if output is not None:
        write_file(output, expanded.text, force=force)
    else:
        print_text(expanded.text)
    return 0
