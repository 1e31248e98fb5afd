"""Robots in folders that the repository does not start: tests, copies of others, backups."""

from __future__ import annotations

from urdfctl.lint.findings.weakening import ASIDE, folder_aside, weakened
from urdfctl.lint.planning import PlannedTarget, TargetOrigin
from urdfctl.smoke.results import ControllerResult, RobotResult, Verdict


def as_aside(entry: PlannedTarget, robot: RobotResult) -> RobotResult:
    """Return the result of a robot, in which nothing fails if the robot lies aside and the user does not name it."""
    linted = robot.linted
    folder = None if entry.origin is TargetOrigin.NAMED else folder_aside(linted.launch or linted.path)
    if folder is None:
        return robot
    why = ASIDE.format(folder)

    def warned(result: ControllerResult) -> ControllerResult:
        if result.verdict is not Verdict.FAILED:
            return result
        return result._replace(verdict=Verdict.WARNED, reason=f"{why}; it would fail: {result.reason}")

    linted = linted._replace(outcome=weakened(linted.outcome, [], why))
    return robot._replace(linted=linted, controllers=tuple(map(warned, robot.controllers)))
