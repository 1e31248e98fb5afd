"""`urdfctl smoke`."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence

from urdfctl.cli.looking import found_by, targets_of
from urdfctl.cli.progress import watched
from urdfctl.cli.words import split_arguments
from urdfctl.cli.writing import print_text, tell, write_file
from urdfctl.config import Config
from urdfctl.errors import UserError
from urdfctl.lint import Selection, joined, worst
from urdfctl.load import Target
from urdfctl.record import NamedTuple
from urdfctl.settings import Settings
from urdfctl.shards import Shard, share
from urdfctl.smoke.engines import NAMES, installed
from urdfctl.smoke.job import Wanted, smoke_all
from urdfctl.smoke.reports import SmokeReport, report_of, text_pieces, written
from urdfctl.smoke.results import Smoked
from urdfctl.suggest import did_you_mean

ENGINES = ("auto", *NAMES, "both", "none")


class Asked(NamedTuple):
    """What a smoke command was asked for; `outputs` are formats with the file they go to, None for standard output;
    of the robots it is all, or one share; `page` is the file that the page of HTML goes to."""

    words: tuple[str, ...]
    wanted: Wanted
    controllers: tuple[str, ...] = ()
    outputs: tuple[tuple[str, str | None], ...] = (("text", None),)
    jobs: int = 0
    shard: Shard | None = None
    page: str | None = None
    config: Config = Config()


def run_smoke(asked: Asked, settings: Settings) -> int:
    """Test what the words mean, report it, and give the exit status."""
    paths, arguments = split_arguments(asked.words)
    found = found_by(paths, asked.config)
    targets, kept = targets_of(found, tuple(arguments.items()), asked.config.robots)
    targets = [_with_controllers(target, asked.controllers) for target in targets]
    if asked.shard is not None:
        mine = share(found, asked.shard, [robot.files for robot in asked.config.robots])
        pairs = [pair for pair in zip(targets, kept, strict=True) if os.path.abspath(pair[0].path) in mine]
        targets, kept = [target for target, _ in pairs], [keep for _, keep in pairs]

    def chosen(judged: list[Smoked]) -> Iterator[int]:
        return _told([one if keep(one.linted) else None for one, keep in zip(judged, kept, strict=True)])

    results = smoke_all(targets, settings, asked.wanted, asked.jobs or None, chosen)
    smoked = list(watched(results, len(targets), "testing"))
    if not smoked:
        tell(f"no robot found in {', '.join(paths) or 'this folder'}")
    outcomes = [one.linted.outcome for one in smoked]
    findings = [one for one in joined(outcomes, Selection()) if not asked.config.ignores(one.at.file, one.code)]
    report = report_of(smoked, findings)
    for name, file in asked.outputs:
        _tell(report, name, file)
    if asked.page:
        from urdfctl.smoke.page import page

        write_file(asked.page, page(report), force=True)
    if any(outcome.crashed for outcome in outcomes):
        return 3
    gravest = worst(findings)
    return int(gravest is not None and gravest.weight >= report.found.fail_on.weight)


def _with_controllers(target: Target, controllers: Sequence[str]) -> Target:
    return target._replace(controllers=(*target.controllers, *controllers))


def _told(smoked: list[Smoked | None]) -> Iterator[int]:
    """The indices of those that are to be told of: each robot with its controllers once, and without controllers only
    where no launch file gives it any."""
    driven = {one.linted.path for one in smoked if one and one.controllers}
    seen = set()
    for index, one in enumerate(smoked):
        if one is None:
            continue
        key = one.linted.path, one.linted.controllers, tuple(result.name for result in one.controllers)
        if key not in seen and (one.controllers or one.linted.path not in driven):
            seen.add(key)
            yield index


def engines_of(name: str) -> tuple[str, ...]:
    """The engines that a name means. UserError where there is no such engine, or it is not installed."""
    if name not in ENGINES:
        raise UserError(f"unknown engine '{name}'{did_you_mean(name, ENGINES)}; known are {', '.join(ENGINES)}")
    if name == "none":
        return ()
    there = installed()
    wanted = NAMES if name == "both" else there[:1] if name == "auto" else (name,)
    if not wanted or not set(wanted) <= set(there):
        missing = "no physics engine" if name == "auto" else "not every engine" if name == "both" else f"'{name}'"
        is_there = "is installed" if name in ("auto", "both") else "is not installed"
        raise UserError(
            f"{missing} {is_there}: pip install 'urdfctl[smoke]', or use --engine none to test without moving anything"
        )
    return wanted


def _tell(report: SmokeReport, name: str, file: str | None) -> None:
    if file is not None:
        write_file(file, written(report, name), force=True)
    elif name == "text" and sys.stdout.isatty() and not os.environ.get("NO_COLOR"):
        from urdfctl.report.text import print_pieces

        print_pieces(text_pieces(report))
    else:
        print_text(written(report, name))
