"""Write the page of a run: `--report`."""

from __future__ import annotations

import os
import shlex
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from datetime import datetime, timezone
from itertools import groupby
from typing import TYPE_CHECKING, TypeVar

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Severity
from urdfctl.lint.results import Report, TargetResult
from urdfctl.load.target import Target
from urdfctl.output.printing import print_message
from urdfctl.output.writing import write_file
from urdfctl.page.run import RunFacts, doctor_page, lint_page, smoke_page
from urdfctl.report.common import is_robot
from urdfctl.smoke.reports import SmokeReport
from urdfctl.smoke.results import RobotResult
from urdfctl.view.job import Portrait, portraits

if TYPE_CHECKING:
    from urdfctl.doctor.recording import Recording
    from urdfctl.doctor.run import DoctorReport

MOST_ROBOTS = 12
"""A page shows at most this many robots of a lint run, those with most errors; the findings of all are in it."""
_Result = TypeVar("_Result")
Watch = Callable[[Iterator[Portrait], int, str], Iterator[Portrait]]
"""Is given pictures as they come, with their number and what is done, and gives them back."""


def write_lint_page(
    path: str,
    report: Report,
    pairs: Iterable[tuple[Target, TargetResult]],
    settings: Settings,
    *,
    began: float,
    watch: Watch,
) -> None:
    """Write the page of a lint run; began: when it started, as time.monotonic() tells it."""
    robots = [(target, result) for target, result in pairs if is_robot(result) and not result.library]
    robots.sort(key=lambda pair: (-_errors(pair[1]), not pair[1].controllers))
    if len(robots) > MOST_ROBOTS:
        print_message(f"{path} shows {MOST_ROBOTS} of {len(robots)} robots, and the findings of all")
    shown = _with_portraits(robots[:MOST_ROBOTS], settings, watch)
    write_file(path, lint_page(report, shown, _facts(began, path)), force=True)


def write_smoke_page(
    path: str,
    report: SmokeReport,
    pairs: Sequence[tuple[tuple[Settings, Target], RobotResult]],
    *,
    began: float,
    watch: Watch,
    kind: str = "Smoke test",
) -> None:
    """Write the page of a smoke run; began: when it started, as time.monotonic() tells it. kind: its heading."""
    shown = []
    for settings, group in groupby(pairs, key=lambda pair: pair[0][0]):
        shown += _with_portraits([(target, smoked) for (_, target), smoked in group], settings, watch)
    write_file(path, smoke_page(report, shown, _facts(began, path), kind), force=True)


def write_doctor_page(
    path: str, report: DoctorReport, recording: Recording, settings: Settings, *, began: float, watch: Watch
) -> None:
    """Write the page of a running system; began: when the question began, as time.monotonic() tells it."""
    targets = [target for target, _ in report.robots]
    drawn = list(watch(portraits(targets, settings), len(targets), "drawing"))
    write_file(path, doctor_page(report, recording, drawn, _facts(began, path)), force=True)


def write_film(path: str, pairs: Sequence[tuple[tuple[Settings, Target], RobotResult]], *, watch: Watch) -> None:
    """Write the motions of a smoke run as a film."""
    from urdfctl.page.film import film_of

    moved = [pair for pair in pairs if pair[1].curves]
    shown = []
    for settings, group in groupby(moved, key=lambda pair: pair[0][0]):
        shown += _with_portraits([(target, smoked) for (_, target), smoked in group], settings, watch)
    film = film_of(path, [robot for robot, _ in shown], [portrait.scene for _, portrait in shown])
    write_file(path, film, force=True)


def _errors(result: TargetResult) -> int:
    return sum(finding.severity is Severity.ERROR for finding in result.outcome.diagnostics)


def _with_portraits(
    pairs: Sequence[tuple[Target, _Result]], settings: Settings, watch: Watch
) -> list[tuple[_Result, Portrait]]:
    made = watch(portraits([target for target, _ in pairs], settings), len(pairs), "drawing")
    return [(result, portrait) for (_, result), portrait in zip(pairs, made, strict=True)]


def _facts(began: float, path: str) -> RunFacts:
    """What the page says of the run. SOURCE_DATE_EPOCH replaces the date, so that pages can be reproduced."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    now = datetime.fromtimestamp(int(epoch) if epoch.isdigit() else time.time(), timezone.utc)
    return RunFacts(
        command=shlex.join(["urdfctl", *sys.argv[1:]]),
        date=now.isoformat(timespec="seconds"),
        seconds=time.monotonic() - began,
        folder=os.path.dirname(os.path.abspath(path)),
    )
