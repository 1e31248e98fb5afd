"""Join launch files that spawn controllers and start no robot with the start beside which they are started."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence

from urdfctl.lint.joining import joined
from urdfctl.lint.results import TargetResult
from urdfctl.load.target import Target
from urdfctl.smoke.checked_robot import CheckedRobot


def with_joined(
    targets: Sequence[Target], robots: Sequence[CheckedRobot], check: Callable[[list[Target]], Iterable[CheckedRobot]]
) -> list[CheckedRobot]:
    """Return robots, where each launch file without a robot has the only start beside which it may be started.

    What such a start shows alone is left out: it is tested with the controllers that are started beside it.

    check: returns targets, loaded and judged.
    """
    checked: dict[Target, CheckedRobot] = {}

    def lint(more: list[Target]) -> Iterable[tuple[Target, TargetResult]]:
        for target, robot in zip(more, check(more), strict=True):
            checked[target] = robot
            yield target, robot.result.linted

    pairs = [(target, robot.result.linted) for target, robot in zip(targets, robots, strict=True)]
    made = joined(pairs, {id(linted) for _, linted in pairs}, lint, alone=True)
    found = [
        robot._replace(result=robot.result._replace(controllers=()), plan=None)
        if id(robot.result.linted) in made.replaced
        else robot
        for robot in robots
    ]
    positions = {os.path.abspath(target.path): number for number, target in enumerate(targets)}
    for target, linted in made.results:
        last = target.beside[-1].path if target.beside else target.launch or target.path
        robot = checked[target]
        result = robot.result._replace(linted=linted, paired=True)
        found[positions[os.path.abspath(last)]] = robot._replace(result=result)
    return found
