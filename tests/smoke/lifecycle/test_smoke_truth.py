"""Without an engine, the smoke test agrees with the verdicts of the real controller managers on small cases."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import pytest
import yaml
from corpus import SHARED
from sampling import WHOLE, sample
from smoking import smoked

from urdfctl.load.target import Target
from urdfctl.model.stage import Stage
from urdfctl.smoke.results import RobotResult

TRUTH = SHARED / "truth"
EVERY = 7
"""The default tests read each seventh case."""
SIMULATORS = {
    "ros1": "gazebo-classic",
    "ros1_good": "gazebo-classic",
    "ros2_controllers": "none",
    "ros2_good": "none",
    "ros2_manager": "none",
}
ONE_FAULT = ("ros1", "ros1_good", "ros2_controllers", "ros2_good")
"""The suites whose cases have at most one fault each, made on purpose."""
MANAGER = ("ros2_manager",)
"""The suite of configurations that were written by hand and mutated at random."""
STAGES = {"load": Stage.LOAD, "configure": Stage.CONFIGURE, "activate": Stage.ACTIVATE, "start": Stage.ACTIVATE}

# Of MANAGER, as measured: lower them when the smoke test gets better, never raise them.
VERDICTS_WRONG = 5 / 604
"""Whether the manager rejects anything."""
STAGES_WRONG = 3 / 276
"""The stage at which it does, of the cases that both reject."""
CONTROLLERS_WRONG = 5 / 566
"""Which of several controllers it rejects."""


def tolerated(share: float, asked: int) -> float:
    """Return how many cases may be wrong: a sample may hold twice its share of them."""
    return share * asked * (1.001 if WHOLE else 2)


pytestmark = pytest.mark.skipif(
    not TRUTH.is_dir(), reason="the verdicts of the real runtimes are not beside the checkout"
)


class Case(NamedTuple):
    name: str
    refused: bool
    stage: str | None
    of_controllers: dict[str, str]
    smoked: RobotResult


def _smoked(file: Path, case: dict[str, Any], distro: str) -> RobotResult:
    order = case.get("activation_order") or case.get("controllers")
    started = tuple(order) if isinstance(order, list) and all(isinstance(name, str) for name in order) else None
    names = [str(file.parent / name) for name in case["files"]]
    robots = [name for name in names if not name.endswith(".yaml")]
    controllers = tuple(name for name in names if name.endswith(".yaml"))
    target = Target([*robots, *controllers][0], controllers=controllers)
    return smoked(target, distro=distro, simulator=SIMULATORS[file.parent.parent.name], started=started)


@lru_cache
def cases(suites: tuple[str, ...]) -> tuple[Case, ...]:
    """All decidable cases of some suites, with the result of the smoke test."""
    made = []
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    files = sorted(file for suite in suites for file in TRUTH.glob(f"{suite}/*/verdict.yaml"))
    for file in sample(files, EVERY):
        case = yaml.load(file.read_text(encoding="utf-8"), loader)  # noqa: S506 (a safe loader)
        for distro, verdict in case["distros"].items() if "undecidable" not in case else ():
            if "skip" not in verdict:
                of_controllers = verdict.get("controllers") or {}
                refused = verdict["verdict"] == "error"
                name = f"{file.parent.parent.name}/{file.parent.name}"
                made.append(Case(name, refused, verdict.get("stage"), of_controllers, _smoked(file, case, distro)))
    return tuple(made)


def refused(made: RobotResult) -> bool:
    """Return whether a manager would reject anything, leaving out what only a simulation shows."""
    return any(finding.code <= "UC905" for finding in made.linted.outcome.diagnostics)


def wrong_verdicts(suites: tuple[str, ...]) -> tuple[list[str], int]:
    """Return the cases whose verdict differs, and the number of all cases."""
    asked = cases(suites)
    return [case.name for case in asked if refused(case.smoked) != case.refused], len(asked)


def wrong_stages(suites: tuple[str, ...]) -> tuple[list[object], int]:
    """Return the cases that stop at another stage, and the number of cases that both reject."""
    asked = [case for case in cases(suites) if case.refused and case.stage in STAGES and refused(case.smoked)]
    wrong: list[object] = []
    for case in asked:
        stages = [result.stage for result in case.smoked.controllers if result.verdict.value == "failed"]
        if STAGES[case.stage or ""] not in stages:
            wrong.append((case.name, case.stage, [stage.value for stage in stages]))
    return wrong, len(asked)


def wrong_controllers(suites: tuple[str, ...]) -> tuple[list[object], int]:
    """Return the cases in which other controllers are rejected, and the number of cases with several controllers."""
    asked = [case for case in cases(suites) if len(case.of_controllers) > 1 and not case.smoked.linted.outcome.crashed]
    wrong: list[object] = []
    for case in asked:
        results = case.smoked.controllers
        ours = {result.name: result.verdict.value == "failed" and result.stage is not Stage.MOVE for result in results}
        real = {name: verdict != "ok" for name, verdict in case.of_controllers.items()}
        if ours != real:
            wrong.append((case.name, ours, real))
    return wrong, len(asked)


def test_its_verdict_is_that_of_the_controller_manager() -> None:
    wrong, asked = wrong_verdicts(ONE_FAULT)
    assert len(wrong) <= 0.02 * asked, wrong


def test_the_stage_is_the_one_at_which_the_controller_manager_refuses() -> None:
    wrong, asked = wrong_stages(ONE_FAULT)
    assert asked > (400 if WHOLE else 400 / EVERY)
    assert len(wrong) <= 0.05 * asked, wrong


def test_of_several_controllers_the_right_ones_are_refused() -> None:
    wrong, asked = wrong_controllers(ONE_FAULT)
    assert len(wrong) <= 0.05 * asked, wrong


def test_its_verdict_on_mutated_configurations_is_that_of_the_controller_manager() -> None:
    wrong, asked = wrong_verdicts(MANAGER)
    assert len(wrong) <= tolerated(VERDICTS_WRONG, asked), wrong


def test_the_stage_of_mutated_configurations_is_that_of_the_controller_manager() -> None:
    wrong, asked = wrong_stages(MANAGER)
    assert len(wrong) <= tolerated(STAGES_WRONG, asked), wrong


def test_of_several_controllers_in_mutated_configurations_the_right_ones_are_refused() -> None:
    wrong, asked = wrong_controllers(MANAGER)
    assert len(wrong) <= tolerated(CONTROLLERS_WRONG, asked), wrong
