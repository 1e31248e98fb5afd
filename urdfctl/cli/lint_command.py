"""`urdfctl lint`."""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass

from urdfctl.cli.options import split_arguments
from urdfctl.cli.writing import write_file
from urdfctl.diagnostic import Severity
from urdfctl.discover import find
from urdfctl.errors import UserError
from urdfctl.lint import Selection, joined, worst
from urdfctl.load import Linted, Target, lint_all
from urdfctl.report import FORMATS
from urdfctl.report.common import Report
from urdfctl.report.text import print_coloured
from urdfctl.settings import Settings
from urdfctl.suggest import did_you_mean


@dataclass(frozen=True, slots=True)
class Wanted:
    """What a lint command was asked for."""

    words: tuple[str, ...]
    select: tuple[str, ...]
    ignore: tuple[str, ...]
    extend: tuple[str, ...]
    formats: tuple[str, ...]
    fail_on: str
    exit_zero: bool
    jobs: int


def run_lint(wanted: Wanted, settings: Settings) -> int:
    """Lint what the words mean, report it, and give the exit status."""
    selection = Selection(wanted.select, wanted.ignore, wanted.extend)
    threshold = _severity(wanted.fail_on)
    outputs = [_output(text) for text in wanted.formats]
    paths, arguments = split_arguments(wanted.words)
    found = find(paths)
    descriptions = found.descriptions()
    if not descriptions and not found.controllers and not found.launches:
        sys.stderr.write(f"urdfctl: no robot found in {', '.join(paths) or 'this folder'}\n")
    targets = [Target(path, tuple(arguments.items())) for path, _ in descriptions]
    linted = lint_all(targets, settings, selection, wanted.jobs or None)
    kept = [one for one, (_, named) in zip(linted, descriptions, strict=True) if named or _is_robot(one)]
    outcomes = [one.outcome for one in kept]
    report = Report(tuple(kept), tuple(joined(outcomes, selection)))
    for name, file in outputs:
        _tell(report, name, file)
    if any(outcome.crashed for outcome in outcomes):
        return 3
    gravest = worst(report.findings)
    return int(gravest is not None and gravest.weight >= threshold.weight and not wanted.exit_zero)


def _is_robot(linted: Linted) -> bool:
    """Whether a file found in a folder is a robot: it has two links, or nothing of it could be read at all."""
    return linted.links is None or linted.links > 1


def _severity(name: str) -> Severity:
    try:
        return Severity(name)
    except ValueError:
        raise UserError(f"--fail-on is one of error, warning, info; not '{name}'") from None


def _output(text: str) -> tuple[str, str | None]:
    name, mark, file = text.partition("=")
    if name not in FORMATS:
        raise UserError(f"unknown format '{name}'{did_you_mean(name, FORMATS)}; known are {', '.join(FORMATS)}")
    if mark and not file:
        raise UserError(f"--format {name}= names no file")
    return name, file or None


def _tell(report: Report, name: str, file: str | None) -> None:
    if file is not None:
        write_file(file, FORMATS[name](report), force=True)
    elif name == "text" and sys.stdout.isatty() and not os.environ.get("NO_COLOR"):
        print_coloured(report)
    else:
        _print(FORMATS[name](report))


def _print(text: str) -> None:
    sys.stdout.flush()
    sys.stdout.buffer.write(text.encode("utf-8", "surrogateescape"))
    sys.stdout.buffer.flush()
