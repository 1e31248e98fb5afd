"""Smoke tests in this process, of files given as text or in folders."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.rules.examples import companions, unmarked
from urdfctl.smoke.job import Wanted, moved, prepared_robot
from urdfctl.smoke.judgement import judged
from urdfctl.smoke.results import Smoked
from urdfctl.smoke.trial import tried


def target_of(folder: Path, files: Mapping[str, str], arguments: tuple[tuple[str, str], ...] = ()) -> Target:
    """Write files to a folder and return them as a target: the first is the robot, or a controller file alone."""
    plain, _ = unmarked(files)
    for name, text in plain.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    controllers, launch = companions(plain)
    paths = tuple(str(folder / name) for name in controllers)
    return Target(str(folder / next(iter(plain))), arguments, controllers=paths, launch=launch and str(folder / launch))


def smoked(target: Target, only: tuple[str, ...] = (), **options: object) -> Smoked:
    """Return a smoke test without a physics engine."""
    settings = Settings(**options)  # type: ignore[arg-type]
    return judged(lint_target(Loader(settings), target, Selection()), only).smoked


def verdicts(result: Smoked) -> dict[str, str]:
    """Return the verdict on each controller with the stage that it reached, by name."""
    return {
        controller.name: f"{controller.verdict.value} {controller.stage.value}" for controller in result.controllers
    }


def whole(target: Target, engine: str = "pybullet", only: tuple[str, ...] = (), **options: object) -> Smoked:
    """Return a smoke test with a physics engine in this process."""
    settings = Settings(**options)  # type: ignore[arg-type]
    loader = Loader(settings)
    robot = prepared_robot(loader, target, Wanted(only, (engine,)))
    if robot.plan is None:
        return robot.smoked
    return moved(robot.smoked, robot, engine, tried(robot.plan._replace(engine=engine)))


def codes(result: Smoked) -> list[str]:
    """Return the codes of the findings, sorted, each once."""
    return sorted({finding.code for finding in result.linted.outcome.diagnostics})
