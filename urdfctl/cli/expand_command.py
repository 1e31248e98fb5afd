"""`urdfctl expand`."""

from __future__ import annotations

import os
import sys

from urdfctl.cli.slips import check_path
from urdfctl.cli.words import configured, settings_from, split_arguments
from urdfctl.cli.writing import print_text, would_overwrite, write_file
from urdfctl.errors import UserError
from urdfctl.expand.job import expand_file
from urdfctl.names import nearest_path
from urdfctl.report.common import Report
from urdfctl.report.text import render
from urdfctl.startup.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfctl.cli.options import ExpandOptions


def run_expand(options: ExpandOptions) -> int:
    """Print or write the expanded file, and return the exit status.

    On an error, print the first problem to standard error; the status is 1.
    """
    file, output, force = options.file, options.output, options.force
    settings = settings_from(configured([file], options), options)
    paths, arguments = split_arguments(options.arguments or [])
    if paths:
        raise UserError(f"unexpected argument '{paths[0]}': expand reads one file; arguments are name:=value")
    if not os.path.lexists(file):
        check_path(file)
        raise UserError(f"file '{file}' does not exist{nearest_path(file)}")
    if output is not None and would_overwrite(output) and not force:
        raise UserError(f"'{output}' exists; --force overwrites it")
    expanded = expand_file(file, arguments, settings)
    if expanded.text is None:
        sys.stderr.write(render(Report((), expanded.problems, quiet=True)))
        return 3 if expanded.crashed else 1
    sys.stderr.write(render(Report((), expanded.problems, quiet=True)))
    if output is not None:
        write_file(output, expanded.text, force=force)
    else:
        print_text(expanded.text)
    return 0
