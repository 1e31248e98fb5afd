"""Smoke tests in process: of files on the page, and of folders."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from urdfctl.lint import Selection
from urdfctl.load import Loader, Target
from urdfctl.rules.examples import companions, unmarked
from urdfctl.settings import Settings
from urdfctl.smoke.job import Wanted, moved, read_of
from urdfctl.smoke.judgement import judged
from urdfctl.smoke.results import Smoked
from urdfctl.smoke.trial import tried


def target_of(folder: Path, files: Mapping[str, str], arguments: tuple[tuple[str, str], ...] = ()) -> Target:
    """Files written to a folder, the first of them the robot (or controllers alone)."""
    plain, _ = unmarked(files)
    for name, text in plain.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    controllers, launch = companions(plain)
    paths = tuple(str(folder / name) for name in controllers)
    return Target(str(folder / next(iter(plain))), arguments, controllers=paths, launch=launch and str(folder / launch))


def smoked(target: Target, only: tuple[str, ...] = (), **options: object) -> Smoked:
    """The structural part of a smoke test."""
    settings = Settings(**options)  # type: ignore[arg-type]
    return judged(Loader(settings, Selection()).seen(target), only).smoked


def verdicts(made: Smoked) -> dict[str, str]:
    """The verdict on each controller and the step it got to, in short."""
    return {one.name: f"{one.verdict.value} {one.stage.value}" for one in made.controllers}


def whole(target: Target, engine: str = "pybullet", only: tuple[str, ...] = (), **options: object) -> Smoked:
    """A whole smoke test, moved in this process."""
    settings = Settings(**options)  # type: ignore[arg-type]
    loader = Loader(settings, Selection())
    read = read_of(loader, target, Wanted(only, (engine,)))
    return moved(read.smoked, read, engine, tried(read.plan._replace(engine=engine))) if read.plan else read.smoked


def codes(made: Smoked) -> list[str]:
    """The codes that were found, in their order, each once."""
    return sorted({one.code for one in made.linted.outcome.diagnostics})
