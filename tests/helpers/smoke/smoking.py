"""Smoke tests in this process, of files given as text or in folders."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from urdfctl.config.settings import Settings
from urdfctl.lint.examples import write_files
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.rules.examples import companions, unmarked
from urdfctl.smoke.checked_robot import CheckedRobot
from urdfctl.smoke.motion.trial import run_trial
from urdfctl.smoke.results import RobotResult
from urdfctl.smoke.robot_motion import with_engine_result
from urdfctl.smoke.run import SmokeRequest, check, judge, load, move
from urdfctl.smoke.statics.check import check_statically


def target_of(folder: Path, files: Mapping[str, str], arguments: tuple[tuple[str, str], ...] = ()) -> Target:
    """Write files to a folder and return them as a target: the first is the robot, or a controller file alone."""
    plain, _ = unmarked(files)
    write_files(plain, str(folder))
    controllers, launch = companions(plain)
    paths = tuple(str(folder / name) for name in controllers)
    return Target(str(folder / next(iter(plain))), arguments, controllers=paths, launch=launch and str(folder / launch))


def smoked(target: Target, only: tuple[str, ...] = (), **options: object) -> RobotResult:
    """Return a smoke test without a physics engine."""
    settings = Settings(**options)  # type: ignore[arg-type]
    return check_statically(lint_target(Loader(settings), target, Selection()), only).result


def verdicts(result: RobotResult) -> dict[str, str]:
    """Return the verdict on each controller with the stage that it reached, by name."""
    return {
        controller.name: f"{controller.verdict.value} {controller.stage.value}" for controller in result.controllers
    }


def checked(loader: Loader, target: Target, request: SmokeRequest) -> CheckedRobot:
    """Return a target as its first worker would, in this process."""
    return judge(load(loader, target), loader, request)


def smoked_in_workers(
    targets: Sequence[Target], settings: Sequence[Settings], request: SmokeRequest, parallel: int | None = None
) -> list[RobotResult]:
    """Return the smoke test of each target, which is read with its own settings, in workers."""
    request = request._replace(parallel=parallel)
    return list(move(check(targets, settings, request), request, settings[0]))


def whole(target: Target, engine: str = "pybullet", only: tuple[str, ...] = (), **options: object) -> RobotResult:
    """Return a smoke test with a physics engine in this process."""
    settings = Settings(**options)  # type: ignore[arg-type]
    loader = Loader(settings)
    robot = checked(loader, target, SmokeRequest(only, (engine,)))
    if robot.plan is None:
        return robot.result
    return with_engine_result(robot.result, robot, engine, run_trial(robot.plan._replace(engine=engine)))


def codes(result: RobotResult) -> list[str]:
    """Return the codes of the findings, sorted, each once."""
    return sorted({finding.code for finding in result.linted.outcome.diagnostics})
