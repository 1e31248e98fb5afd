"""The results of engines put together: several of them, tasks for one of many robots, and how far a controller came."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest
from smoke_robots import ARMS
from smoking import codes, smoked, smoked_in_workers, target_of

from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.load.target import Target
from urdfctl.model.stage import Stage
from urdfctl.run.limits import WorkerFailure
from urdfctl.smoke.checked_robot import CheckedRobot
from urdfctl.smoke.motion.engine_workers import EngineWorkers
from urdfctl.smoke.motion.plan import MotionPlan, SimulationResult
from urdfctl.smoke.results import ControllerResult, RobotResult, Trouble, Verdict
from urdfctl.smoke.robot_motion import with_engine_result
from urdfctl.smoke.run import SmokeRequest
from urdfctl.smoke.tasks.task_file import read_tasks

ARM = ARMS["joints that turn level"]
LATE = SimulationResult(
    (Trouble("UC932", "joint:elbow", "joint 'elbow' does not follow", "mover"),), ("states", "mover")
)
SOUND = SimulationResult(moved=("states", "mover"))
CRASHED = WorkerFailure("it was ended by SIGSEGV")
JAZZY = Settings(distro="jazzy")


def ending_in(monkeypatch: pytest.MonkeyPatch, *results: SimulationResult | WorkerFailure) -> None:
    """Let the simulations of a run end with some results, one after the other."""

    def given(_: EngineWorkers, plans: Sequence[MotionPlan]) -> Iterator[tuple[str, SimulationResult | WorkerFailure]]:
        yield from zip([plan.engine for plan in plans], results, strict=True)

    monkeypatch.setattr(EngineWorkers, "results", given)


def arm(folder: Path, name: str = "arm", controller: str = "mover") -> Target:
    yaml = ARM.yaml().replace("mover:", f"{controller}:")
    (folder / name).mkdir()
    return target_of(folder / name, {"robot.urdf": ARM.urdf(), "controllers.yaml": yaml})


# -- two engines -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("results", "expected", "verdict"),
    [
        ((SOUND, SOUND), [], Verdict.PASSED),
        ((LATE, SOUND), ["UC963"], Verdict.WARNED),
        ((LATE, LATE), ["UC932"], Verdict.FAILED),
        ((LATE, CRASHED), ["UC920", "UC932"], Verdict.FAILED),
        ((LATE, SimulationResult(refused="no")), ["UC921", "UC932"], Verdict.FAILED),
    ],
    ids=["both pass", "one fails", "both fail", "one fails and one crashes", "one fails and one rejects"],
)
def test_two_engines_are_compared_if_both_simulate_the_robot(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    results: tuple[SimulationResult | WorkerFailure, ...],
    expected: list[str],
    verdict: Verdict,
) -> None:
    ending_in(monkeypatch, *results)
    [made] = smoked_in_workers([arm(tmp_path)], [JAZZY], SmokeRequest(engines=("pybullet", "mujoco")), 1)
    assert codes(made) == expected
    assert made.controllers[1].verdict is verdict


# -- tasks of a user -------------------------------------------------------------------------------------------------

TASK = "controllers:\n  mover:\n    target: {elbow: 0.1}\n"


def told(folder: Path, monkeypatch: pytest.MonkeyPatch, text: str, *targets: Target) -> str:
    """Return the error that a file of tasks is for some robots, or nothing."""
    path = folder / "tasks.yaml"
    path.write_text(text, encoding="utf-8")
    ending_in(monkeypatch, *[SOUND] * len(targets))
    wanted = SmokeRequest(engines=("mujoco",), tasks=read_tasks(str(path)))
    try:
        list(smoked_in_workers(targets, [JAZZY] * len(targets), wanted, 1))
    except UserError as error:
        return str(error).removeprefix(f"{path}:")
    return ""


def test_a_task_must_fit_one_of_several_robots(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    left, right = arm(tmp_path, "left"), arm(tmp_path, "right", "lifter")
    assert told(tmp_path, monkeypatch, TASK, left, right) == ""
    assert told(tmp_path, monkeypatch, TASK, right) == "2: no robot has a controller 'mover'"


def test_a_task_that_a_robot_with_its_controller_cannot_perform_is_an_error_beside_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    left, right = arm(tmp_path, "left"), arm(tmp_path, "right", "lifter")
    far = TASK.replace("0.1", "5.0")
    assert told(tmp_path, monkeypatch, far, left, right).startswith("3: 5 rad is outside the limits of joint 'elbow'")


# -- how far a controller came ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("verdict", "moves", "by_distro", "stage"),
    [
        (Verdict.WARNED, True, {}, Stage.DEACTIVATE),
        (Verdict.WARNED, False, {}, Stage.ACTIVATE),
        (Verdict.WARNED, True, {"humble": "failed"}, Stage.ACTIVATE),
        (Verdict.FAILED, True, {}, Stage.ACTIVATE),
        (Verdict.SKIPPED, True, {}, Stage.DEACTIVATE),
        (Verdict.SKIPPED, False, {}, Stage.ACTIVATE),
    ],
)
def test_a_controller_that_moved_went_through_all_stages_unless_it_fails(
    tmp_path: Path, verdict: Verdict, moves: bool, by_distro: dict[str, str], stage: Stage
) -> None:
    before = smoked(arm(tmp_path), distro="jazzy")
    mover = ControllerResult("mover", None, verdict, Stage.ACTIVATE, "for a reason", by_distro=by_distro)
    robot: RobotResult = before._replace(controllers=(mover,))
    trial = SimulationResult(moved=("mover",) if moves else ())
    after = with_engine_result(robot, CheckedRobot(robot, None), "mujoco", trial)
    assert after.controllers[0].stage is stage
