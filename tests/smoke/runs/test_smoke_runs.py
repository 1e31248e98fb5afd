"""The workers of a smoke test: what they know survives their end, and each controller has a line on a terminal."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from folder import CHECKOUT
from smoke_robots import Arm
from smoking import smoked_in_workers, target_of
from smoking_engines import needs_pybullet

from urdfctl.config.settings import Settings
from urdfctl.run.limits import CAN_FORK, WorkerFailure
from urdfctl.smoke.motion import engine_workers
from urdfctl.smoke.motion.plan import MotionPlan, SimulationResult
from urdfctl.smoke.motion.progress import keep, kept, live_lines, stopped_early
from urdfctl.smoke.results import RobotResult, Trouble
from urdfctl.smoke.robot.mechanism import Mechanism
from urdfctl.smoke.run import SmokeRequest
from urdfctl.smoke.tasks.task import ControllerTask, MotionFamily

needs_fork = pytest.mark.skipif(not CAN_FORK, reason="the system cannot fork")
TASKS = tuple(ControllerTask(name, MotionFamily.FORWARD) for name in ("one", "two", "three"))
PLAN = MotionPlan(engine="mujoco", urdf="", mechanism=Mechanism("base", {}, ()), tasks=TASKS, rate=100.0, fixed=True)
SLIP = Trouble("UC932", "joint:a", "joint 'a' is too fast", "two")
KNOWN = SimulationResult((SLIP,), ("one",), tested={"one": ("started", "moved")}, times={"one": 0.25, "two": 0.5})
ARM = Arm()
TWO = """
controller_manager:
  ros__parameters:
    update_rate: 100
    first: {type: forward_command_controller/ForwardCommandController}
    second: {type: joint_trajectory_controller/JointTrajectoryController}
first:
  ros__parameters: {joints: [shoulder], interface_name: position}
second:
  ros__parameters: {joints: [elbow], command_interfaces: [position], state_interfaces: [position]}
"""
"""Two controllers that command in different ways, and so are tested one after the other."""


def reasons(made: RobotResult) -> dict[str, str]:
    return {result.name: f"{result.verdict.value}: {result.reason}" for result in made.controllers}


def test_what_is_known_is_kept_in_a_file(tmp_path: Path) -> None:
    path = str(tmp_path / "known")
    assert kept(path) == SimulationResult()
    keep(KNOWN, path)
    assert kept(path) == KNOWN
    assert os.listdir(tmp_path) == ["known"]


def test_controllers_that_were_not_reached_are_not_tested() -> None:
    made = stopped_early(PLAN, KNOWN, "it takes longer than 5 s")
    assert made.unjudged == {"three": "not tested: it takes longer than 5 s; 2 of 3 controllers tested"}
    assert (made.moved, made.troubles) == (("one",), (SLIP,))


def test_each_controller_has_one_line_on_a_terminal() -> None:
    told: set[str] = set()
    assert list(live_lines(KNOWN, PLAN, told)) == [
        "[1/3] one: started, moved (mujoco, 0.25 s)",
        "[2/3] two: fails: joint 'a' is too fast (mujoco, 0.50 s)",
    ]
    later = KNOWN._replace(unjudged={"three": "not simulated: no range"}, times={**KNOWN.times, "three": 0.0})
    assert list(live_lines(later, PLAN, told)) == ["[3/3] three: not simulated: no range (mujoco, 0.00 s)"]


@needs_fork
@needs_pybullet
def test_a_worker_that_is_ended_for_its_time_loses_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def stuck(_plan: MotionPlan, seen: object) -> SimulationResult:
        assert callable(seen)
        seen(SimulationResult(moved=("first",), tested={"first": ("started", "moved")}))
        time.sleep(60)
        return SimulationResult()

    monkeypatch.setattr(engine_workers, "run_trial", stuck)
    monkeypatch.setattr(engine_workers, "WAITING", 0.0)
    monkeypatch.setattr(engine_workers, "STARTING", 0.5)
    target = target_of(tmp_path, {"robot.urdf": ARM.urdf(interface="position"), "controllers.yaml": TWO})
    [made] = smoked_in_workers([target], [Settings(distro="jazzy")], SmokeRequest(engines=("pybullet",)))
    assert reasons(made) == {
        "first": "passed: ",
        "second": "skipped: not tested: it takes longer than 0.5 s; 1 of 2 controllers tested",
    }
    assert made.linted.outcome.diagnostics == []


def test_a_worker_gets_a_multiple_of_its_processor_time_and_time_to_start() -> None:
    limits = engine_workers.EngineWorkers(Settings(), 1).limits_for(
        [PLAN._replace(budget=10.0), PLAN._replace(budget=20.0)]
    )
    assert limits.seconds == 20.0 * 12 + 60
    assert engine_workers.EngineWorkers(Settings(), 1).limits_for([PLAN._replace(gui=True)]).seconds == 600.0


def test_nothing_more_is_simulated_after_an_interruption() -> None:
    def interrupted() -> object:
        yield {"moved": 1}
        raise KeyboardInterrupt

    simulations = engine_workers.EngineWorkers(Settings(), 1)
    results = list(simulations._until_interrupted(interrupted(), 3))  # type: ignore[arg-type]
    assert results == [{"moved": 1}, *[WorkerFailure("interrupted")] * 2]
    assert simulations.interrupted
    assert list(simulations._until_interrupted(interrupted(), 2)) == [WorkerFailure("interrupted")] * 2  # type: ignore[arg-type]


@needs_fork
@needs_pybullet
def test_ctrl_c_reports_what_was_tested(tmp_path: Path) -> None:
    import pty

    target = target_of(tmp_path, {"robot.urdf": ARM.urdf(interface="position"), "controllers.yaml": TWO})
    ours, terminal = pty.openpty()
    words = ["smoke", target.path, "--controllers", target.controllers[0], "--distro", "jazzy", "--format", "json"]
    command = [sys.executable, "-m", "urdfctl", *words, "--engine", "pybullet", "--duration", "60"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=terminal, cwd=CHECKOUT)
    os.close(terminal)
    line = ""
    while "\n" not in line:
        line += os.read(ours, 1000).decode()
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate()
    os.close(ours)
    assert line.startswith("[1/2] first: started, moved, followed, held (pybullet, ")
    report = json.loads(output)
    told = {each["name"]: (each["verdict"], each["reason"]) for each in report["controllers"]}
    assert told["first"] == ("passed", "")
    assert told["second"] == ("skipped", "not tested: interrupted; 1 of 2 controllers tested")
    assert process.returncode == 130


# -- which engine is believed ------------------------------------------------------------------------------------------

WEAK = Trouble("UC932", "joint:a", "joint 'a' is too fast", "one")
FAILED = SimulationResult((WEAK,), ("one",))
SOUND = SimulationResult((), ("one",))
MESHES = PLAN._replace(engine="pybullet", urdf="<a/>\n<mesh/>\n<b/>")


def settled(
    monkeypatch: pytest.MonkeyPatch, plan: MotionPlan, *results: SimulationResult | WorkerFailure
) -> tuple[str, object, list[str]]:
    """What a run settles on if its simulations end with some results, one after the other, and what was simulated."""
    left, made = list(results), []

    def simulate(_self: object, plans: list[MotionPlan], _parallel: int, _folder: str) -> object:
        made.extend(f"{plan.engine}{' without meshes' if plan.shapeless else ''}" for plan in plans)
        return iter([left.pop(0) for _ in plans])

    monkeypatch.setattr(engine_workers.EngineWorkers, "run_plan", simulate)
    [(engine, result)] = engine_workers.EngineWorkers(Settings(), 1, ["mujoco"]).results([plan])
    return engine, result, made


def test_an_engine_that_finds_no_error_is_believed(monkeypatch: pytest.MonkeyPatch) -> None:
    assert settled(monkeypatch, MESHES, SOUND) == ("pybullet", SOUND, ["pybullet"])


def test_the_second_engine_is_asked_before_a_robot_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    engine, result, made = settled(monkeypatch, MESHES, FAILED, SOUND)
    assert (engine, made) == ("pybullet and mujoco", ["pybullet", "mujoco"])
    assert isinstance(result, SimulationResult)
    [disagreement] = result.troubles
    assert disagreement.message.startswith("pybullet and mujoco disagree; only pybullet reports: ")
    engine, result, made = settled(monkeypatch, MESHES, FAILED, FAILED)
    assert isinstance(result, SimulationResult)
    assert (engine, result.troubles) == ("pybullet and mujoco", (WEAK,))


def test_an_engine_that_crashes_is_tried_without_meshes_and_then_another_one_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    crash = WorkerFailure("was ended by SIGSEGV", our_fault=True)
    assert settled(monkeypatch, MESHES, crash, SOUND)[2] == ["pybullet", "pybullet without meshes"]
    assert settled(monkeypatch, MESHES, crash, crash, FAILED) == (
        "mujoco",
        FAILED,
        ["pybullet", "pybullet without meshes", "mujoco"],
    )
    assert settled(monkeypatch, PLAN._replace(engine="pybullet"), crash, SOUND)[2] == ["pybullet", "mujoco"]
    assert settled(monkeypatch, MESHES, crash, crash, crash)[:2] == ("pybullet", crash)


def test_an_engine_that_rejects_a_robot_leaves_it_to_another_one(monkeypatch: pytest.MonkeyPatch) -> None:
    refused = SimulationResult(refused="two roots")
    assert settled(monkeypatch, MESHES, refused, SOUND)[:2] == ("mujoco", SOUND)
    assert settled(monkeypatch, MESHES, refused, refused)[:2] == ("pybullet", refused)


def test_the_end_of_an_engines_output_is_shown_without_its_greeting(tmp_path: Path) -> None:
    path = tmp_path / "output"
    path.write_text(f"pybullet build time: today\n{'x' * 2000}\nbad  element\n", encoding="utf-8")
    assert engine_workers.engine_output(str(path)) == f"{'x' * 288} bad element"
    path.write_text("pybullet build time: today\nbad\n", encoding="utf-8")
    assert engine_workers.engine_output(str(path)) == "bad"
    assert engine_workers.engine_output(str(tmp_path / "none")) == ""


def test_processor_time_grows_with_joints_and_controllers() -> None:
    assert PLAN.within(30.0).budget == pytest.approx(30.0 * 1.03)
    many = PLAN._replace(tasks=TASKS * 20)
    assert many.within(10.0).budget == pytest.approx(16.0)
    assert (PLAN.budget, PLAN.duration) == (30.0, 2.0)


@needs_fork
def test_only_a_watched_simulation_sees_the_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DISPLAY", ":0")
    assert "DISPLAY" not in engine_workers.EngineWorkers(Settings(), 1).limits_for([PLAN]).environ
    assert engine_workers.EngineWorkers(Settings(), 1).limits_for([PLAN._replace(gui=True)]).environ["DISPLAY"] == ":0"
