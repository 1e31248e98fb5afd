"""Without an engine, the smoke test says of each small case what the real controller managers said."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import pytest
import yaml
from corpus import SHARED
from smoking import smoked

from urdfctl.load import Target
from urdfctl.smoke.results import Smoked, Step

TRUTH = SHARED / "truth"
SIMULATORS = {"ros1": "gazebo-classic", "ros1_good": "gazebo-classic", "ros2_controllers": "none", "ros2_good": "none"}
STAGES = {"load": Step.LOAD, "configure": Step.CONFIGURE, "activate": Step.ACTIVATE, "start": Step.ACTIVATE}

pytestmark = pytest.mark.skipif(
    not TRUTH.is_dir(), reason="the verdicts of the real runtimes are not beside the checkout"
)


class Case(NamedTuple):
    name: str
    refused: bool
    stage: str | None
    of_controllers: dict[str, str]
    made: Smoked


def _made(file: Path, case: dict[str, Any], distro: str) -> Smoked:
    order = case.get("activation_order") or case.get("controllers")
    started = tuple(order) if isinstance(order, list) and all(isinstance(name, str) for name in order) else None
    names = [str(file.parent / name) for name in case["files"]]
    robots = [name for name in names if not name.endswith(".yaml")]
    controllers = tuple(name for name in names if name.endswith(".yaml"))
    target = Target([*robots, *controllers][0], controllers=controllers)
    return smoked(target, distro=distro, simulator=SIMULATORS[file.parent.parent.name], started=started)


@lru_cache
def cases() -> tuple[Case, ...]:
    """All decidable cases, with what the smoke test makes of them."""
    found = []
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    for file in sorted(file for suite in SIMULATORS for file in TRUTH.glob(f"{suite}/*/verdict.yaml")):
        case = yaml.load(file.read_text(encoding="utf-8"), loader)  # noqa: S506 (a safe loader)
        for distro, verdict in case["distros"].items() if "undecidable" not in case else ():
            if "skip" not in verdict:
                of_controllers = verdict.get("controllers") or {}
                refused = verdict["verdict"] == "error"
                name = f"{file.parent.parent.name}/{file.parent.name}"
                found.append(Case(name, refused, verdict.get("stage"), of_controllers, _made(file, case, distro)))
    return tuple(found)


def refused(made: Smoked) -> bool:
    """Whether a manager would refuse anything; what physics finds besides is not its affair."""
    return any(one.code <= "UC905" for one in made.linted.outcome.diagnostics)


def test_its_verdict_is_that_of_the_controller_manager() -> None:
    wrong = [case.name for case in cases() if refused(case.made) != case.refused]
    assert len(wrong) <= 0.02 * len(cases()), wrong


def test_the_step_is_the_one_at_which_the_controller_manager_refuses() -> None:
    told = [case for case in cases() if case.refused and case.stage in STAGES and refused(case.made)]
    wrong = []
    for case in told:
        steps = [one.stage for one in case.made.controllers if one.verdict.value == "failed"]
        if STAGES[case.stage or ""] not in steps:
            wrong.append((case.name, case.stage, [step.value for step in steps]))
    assert len(told) > 400
    assert len(wrong) <= 0.05 * len(told), wrong


def test_of_several_controllers_the_right_ones_are_refused() -> None:
    several = [case for case in cases() if len(case.of_controllers) > 1 and not case.made.linted.outcome.crashed]
    wrong = []
    for case in several:
        said = {one.name: one.verdict.value == "failed" and one.stage is not Step.MOVE for one in case.made.controllers}
        real = {name: verdict != "ok" for name, verdict in case.of_controllers.items()}
        if said != real:
            wrong.append((case.name, said, real))
    assert len(wrong) <= 0.05 * len(several), wrong
