"""The check of a robot before anything moves: its verdicts, what explains them, and the pose that a user gives."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import Arm
from smoking import smoked, target_of

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.model.stage import Stage
from urdfctl.smoke.results import ControllerResult, Trouble, Verdict
from urdfctl.smoke.statics.check import check_statically, with_troubles
from urdfctl.smoke.tasks.task_file import TaskFile

ARM = {"robot.urdf": Arm().urdf(), "controllers.yaml": Arm().yaml()}
STARTED = ControllerResult("arm", None, Verdict.SKIPPED, Stage.ACTIVATE, "not simulated")
STOPPED = STARTED._replace(verdict=Verdict.FAILED, stage=Stage.LOAD, reason="its type is missing")
ERROR = Trouble("UC915", "joint:j", "too weak", "arm")
WARNING = Trouble("UC950", "joint:j", "hardly strong enough", "arm")
OF_DISTRO = Trouble("UC970", "controller:arm", "depends on the distro", "arm")


@pytest.mark.parametrize(
    ("before", "troubles", "verdict", "reason"),
    [
        (STARTED, [], Verdict.SKIPPED, "not simulated"),
        (STARTED, [WARNING], Verdict.WARNED, "hardly strong enough"),
        (STARTED, [ERROR], Verdict.FAILED, "too weak"),
        (STARTED, [WARNING, ERROR], Verdict.FAILED, "too weak"),
        (STARTED, [ERROR._replace(controller="hand")], Verdict.SKIPPED, "not simulated"),
        (STARTED, [ERROR._replace(controller=None)], Verdict.SKIPPED, "not simulated"),
        (STARTED, [OF_DISTRO], Verdict.SKIPPED, "not simulated"),
        (STOPPED, [ERROR], Verdict.FAILED, "its type is missing"),
        (STOPPED, [WARNING], Verdict.FAILED, "its type is missing"),
    ],
)
def test_an_error_fails_its_controller_and_a_warning_warns(
    before: ControllerResult, troubles: list[Trouble], verdict: Verdict, reason: str
) -> None:
    after = with_troubles(before, troubles)
    assert (after.verdict, after.reason) == (verdict, reason)


def test_a_controller_without_a_robot_is_not_simulated_for_that_reason(tmp_path: Path) -> None:
    with_robot = smoked(target_of(tmp_path, ARM), distro="jazzy").controllers[0]
    alone = smoked(Target(str(tmp_path / "controllers.yaml")), distro="jazzy").controllers[0]
    assert with_robot.reason == "not simulated: no physics engine was used"
    assert alone.reason.startswith("not simulated: the robot is not known")


def test_a_robot_whose_joints_are_too_weak_is_judged_without_an_engine(tmp_path: Path) -> None:
    weak = target_of(tmp_path, {**ARM, "robot.urdf": Arm().urdf(effort=1.0)})
    assert "UC915" in {finding.code for finding in smoked(weak, distro="jazzy").linted.outcome.diagnostics}


def test_the_start_of_a_users_tasks_is_where_the_robot_is_judged(tmp_path: Path) -> None:
    seen = lint_target(Loader(Settings(distro="jazzy")), target_of(tmp_path, ARM), Selection())
    start = TaskFile("tasks.yaml", "", (("elbow", 0.7, 1),))
    for given, place in ((None, 0.0), (start, 0.7)):
        mechanism = check_statically(seen, given=given).mechanism
        assert mechanism is not None
        assert mechanism.start()["elbow"] == place
        assert mechanism.start()["shoulder"] == 0.0
