"""`--tasks`: targets, trajectories, velocities, drives and a start pose of the user; and what is wrong with them."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import pytest
from click.testing import Result
from smoke_robots import Arm, Rover
from smoking import target_of
from smoking_engines import EACH_ENGINE, needs_an_engine
from typer.testing import CliRunner

from urdfctl.commands.app import app
from urdfctl.errors import UserError
from urdfctl.smoke.motion.user_tasks import Odometry, reference
from urdfctl.smoke.tasks.task_file import TaskFile, TaskStep, UserTask, read_tasks

ARM = {"robot.urdf": Arm().urdf(interface="position"), "controllers.yaml": Arm().yaml(interface="position")}
LEVEL = Arm("revolute", "0 0 1", 1.0, 0.2, "p: 50.0, i: 0.0, d: 3.0")
"""An arm without gravity on its joints, moved by efforts."""
ROVER = {"robot.urdf": Rover().urdf(), "controllers.yaml": Rover().yaml()}
WHEELS = ROVER["controllers.yaml"].partition("    base:")[0] + (
    "    wheels: {type: velocity_controllers/JointGroupVelocityController}\n"
    "wheels:\n  ros__parameters: {joints: [left_wheel, right_wheel]}\n"
)


def tasks(folder: Path, text: str) -> str:
    path = folder / "tasks.yaml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def smoke(folder: Path, files: dict[str, str], text: str, *words: str) -> Result:
    """Run `urdfctl smoke` with a file of tasks on a robot; as JSON."""
    target = target_of(folder, files)
    given = [target.path, "--controllers", target.controllers[0], "--tasks", tasks(folder, text), "--format", "json"]
    return CliRunner().invoke(app, ["smoke", *given, "--distro", "jazzy", *words])


def report(folder: Path, files: dict[str, str], text: str, *words: str) -> dict[str, object]:
    """The verdicts and findings of a run, with the last measured values."""
    made = smoke(folder, files, text, *words)
    if made.exception and not isinstance(made.exception, SystemExit):
        raise made.exception
    data = json.loads(made.stdout)
    return {
        **{each["name"]: each["verdict"] for each in data["controllers"]},
        "findings": [f"{each['code']} line {each['line']}: {each['message']}" for each in data["findings"]],
        "ends": {each["joint"]: each["measured"] for each in data["measurements"]},
        "curves": {each["joint"]: each for each in data["curves"]},
    }


# -- the file --------------------------------------------------------------------------------------------------------


def test_a_file_is_read_with_its_lines(tmp_path: Path) -> None:
    file = read_tasks(
        tasks(
            tmp_path,
            "start: {elbow: 0.5}\n"
            "controllers:\n"
            "  arm:\n"
            "    trajectory:\n"
            "      - {at: 1, joints: {elbow: 0.1}}\n"
            "      - {at: 2.5, joints: {elbow: 0.2}}\n"
            "    path_tolerance: 0.3\n"
            "  base:\n"
            "    drive: [{for: 1.5, forward: 0.2}, {for: 1, turn: -0.5}]\n",
        )
    )
    arm, base = file.user_tasks
    assert file.start == (("elbow", 0.5, 1),)
    assert arm.steps == (TaskStep(1.0, (("elbow", 0.1),), 5), TaskStep(2.5, (("elbow", 0.2),), 6))
    assert (arm.tolerance, arm.path_tolerance, file.line_of(arm), file.line_of(base)) == (None, 0.3, 3, 8)
    assert base.steps == (TaskStep(1.5, (("forward", 0.2),), 9), TaskStep(2.5, (("turn", -0.5),), 9))
    assert TaskFile.from_json(json.loads(json.dumps(file))) == file


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "1: a file of tasks needs one document, with the key 'controllers'"),
        ("controllers: [", "1: "),
        ("controler: {}", "1: a file of tasks has no 'controler'; did you mean 'controllers'?"),
        ("start: {}", "1: expects joints with numbers: {elbow: 0.5}"),
        ("controllers: {}", "1: no tasks: give 'controllers', 'start' or both"),
        ("controllers:\n  arm: 5", "2: expects names with values: {name: value}"),
        (
            "controllers:\n  arm:\n    tolerance: 1",
            "2: controller 'arm' needs one of target, trajectory, velocity, drive",
        ),
        ("controllers:\n  arm:\n    target: {a: 1}\n    velocity: {a: 1}", "2: controller 'arm' needs one of"),
        ("controllers:\n  arm:\n    target: {a: b}", "3: expects a number, not 'b'"),
        ("controllers:\n  arm:\n    target: {a: .nan}", "3: expects a number, not '.nan'"),
        ("controllers:\n  arm:\n    target: {a: true}", "3: expects a number, not 'true'"),
        ("controllers:\n  arm:\n    target: {a: 1}\n    within: 0", "4: expects a number above 0, not 0"),
        (
            "controllers:\n  arm:\n    target: {a: 1}\n    angle_tolerance: 1",
            "4: 'angle_tolerance' has no meaning beside",
        ),
        ("controllers:\n  arm:\n    trajectory: {a: 1}", "3: 'trajectory' must be a list of steps"),
        ("controllers:\n  arm:\n    trajectory:\n    - {at: 1}", "4: a point of a trajectory needs 'joints'"),
        (
            "controllers:\n  arm:\n    trajectory:\n    - {at: 2, joints: {a: 1}}\n    - {at: 2, joints: {a: 1}}",
            "5: 'at' must rise from point to point: 2 s after 2 s",
        ),
        ("controllers:\n  base:\n    drive:\n    - {forward: 1}", "4: a step of a drive needs 'for'"),
        ("controllers:\n  base:\n    drive: [{for: 61}]", "2: the task of 'base' takes 61 s; at most 60"),
    ],
)
def test_a_bad_task_is_one_line_with_its_place(tmp_path: Path, text: str, why: str) -> None:
    path = tasks(tmp_path, text)
    with pytest.raises(UserError) as caught:
        read_tasks(path)
    assert str(caught.value).startswith(f"{path}:{why}")
    assert "\n" not in str(caught.value)


def test_a_file_that_does_not_exist_is_an_error(tmp_path: Path) -> None:
    tasks(tmp_path, "")
    with pytest.raises(UserError, match=r"file does not exist: '.*taks\.yaml'; did you mean 'tasks\.yaml'"):
        read_tasks(str(tmp_path / "taks.yaml"))


@needs_an_engine
@pytest.mark.parametrize(
    ("files", "text", "why"),
    [
        (ARM, "controllers: {arm: {target: {elbow: 1}}}", "1: no robot has a controller 'arm'"),
        (ARM, "controllers:\n  mover:\n    target: {elbw: 1}", "3: controller 'mover' does not command joint 'elbw'"),
        (ARM, "controllers:\n  mover:\n    target: {elbow: 1.5}", "3: 1.5 rad is outside the limits of joint 'elbow'"),
        (ARM, "controllers:\n  mover:\n    velocity: {elbow: 1}", "3: controller 'mover' cannot perform a velocity"),
        (ARM, "controllers:\n  states:\n    target: {elbow: 1}", "3: controller 'states' cannot perform a target"),
        (ARM, "start: {wrist: 1}", "1: no robot has a joint 'wrist'"),
        (ARM, "start: {elbow: -2}", "1: -2 rad is outside the limits of joint 'elbow', -1 to 1 rad"),
        (ROVER, "controllers:\n  base:\n    target: {left_wheel: 1}", "3: controller 'base' cannot perform a target"),
    ],
)  # fmt: skip
def test_a_task_that_does_not_fit_the_robot_is_one_line_too(
    tmp_path: Path, files: dict[str, str], text: str, why: str
) -> None:
    made = smoke(tmp_path, files, text)
    assert isinstance(made.exception, UserError)
    assert str(made.exception).partition("tasks.yaml:")[2].startswith(why)


def test_tasks_need_an_engine(tmp_path: Path) -> None:
    made = smoke(tmp_path, ARM, "start: {elbow: 0.1}", "--engine", "none")
    assert str(made.exception) == "--tasks requires a physics engine, not --engine none"


# -- the motion ------------------------------------------------------------------------------------------------------

PATH = UserTask(
    "arm", "trajectory", (TaskStep(1.0, (("a", 2.0),), 1), TaskStep(3.0, (("a", 1.0), ("b", 5.0)), 2)), (0, 0)
)


def test_a_path_passes_its_points_and_stops_there() -> None:
    assert [reference(PATH, 0.5, "a", seconds) for seconds in (0.0, 1.0, 3.0, 9.0)] == [
        (0.5, 0.0),
        (2.0, 0.0),
        (1.0, 0.0),
        (1.0, 0.0),
    ]
    assert reference(PATH, 0.5, "b", 1.0) == (0.5, 0.0)
    assert reference(PATH, 0.5, "a", 2.0)[0] == pytest.approx(1.5)


@pytest.mark.parametrize("seconds", [0.3, 0.9, 1.4, 2.9])
def test_its_velocity_is_the_derivative_of_its_position(seconds: float) -> None:
    step = 1e-6
    before, after = (reference(PATH, 0.5, "a", seconds + side)[0] for side in (-step, step))
    assert reference(PATH, 0.5, "a", seconds)[1] == pytest.approx((after - before) / (2 * step), rel=1e-4)


def test_a_base_that_drives_a_circle_returns() -> None:
    place, steps = Odometry(), 1000
    for _ in range(steps):
        place = place.on(2 * math.pi * 0.5 / steps, 2 * math.pi / steps)
    assert (place.x, place.y, place.yaw, place.way) == pytest.approx((0.0, 0.0, 2 * math.pi, math.pi), abs=1e-6)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_joints_go_to_their_targets_from_the_start_pose(tmp_path: Path, engine: str) -> None:
    text = "start: {shoulder: -0.5}\ncontrollers: {mover: {target: {shoulder: 0.4, elbow: -0.3}, within: 1}}"
    made = report(tmp_path, ARM, text, "--engine", engine)
    assert (made["mover"], made["findings"]) == ("passed", [])
    assert made["ends"] == pytest.approx({"shoulder": 0.4, "elbow": -0.3}, abs=0.02)
    assert made["curves"]["shoulder"]["measured"][0] == pytest.approx(-0.5, abs=0.03)  # type: ignore[index]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_loop_follows_a_trajectory_within_its_tolerances(tmp_path: Path, engine: str) -> None:
    files = {"robot.urdf": LEVEL.urdf(), "controllers.yaml": LEVEL.yaml()}
    points = "[{at: 1, joints: {shoulder: 0.5}}, {at: 2, joints: {shoulder: 0.0, elbow: 0.4}}]"
    text = "controllers:\n  mover:\n    trajectory: %s\n    path_tolerance: %s"
    made = report(tmp_path, files, text % (points, 0.2), "--engine", engine)
    assert (made["mover"], made["findings"]) == ("passed", [])
    strict = report(tmp_path, files, text % (points, 0.001), "--engine", engine)
    assert strict["mover"] == "failed"
    assert all(line.startswith("UC971 line 2: ") and "off its path" in line for line in strict["findings"])  # type: ignore[attr-defined]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_target_that_is_not_reached_is_reported_at_its_line(tmp_path: Path, engine: str) -> None:
    weak = {"robot.urdf": Arm().urdf(), "controllers.yaml": Arm().yaml("p: 100.0, i: 0.0, d: 10.0")}
    made = report(tmp_path, weak, "controllers:\n  mover: {target: {shoulder: 0.5}}", "--engine", engine)
    [line] = made["findings"]  # type: ignore[misc]
    assert line.startswith("UC971 line 2: controller 'mover' does not perform its task: joint 'shoulder' ends at ")
    assert made["mover"] == "failed"


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_wheels_turn_at_their_velocity(tmp_path: Path, engine: str) -> None:
    files = {"robot.urdf": ROVER["robot.urdf"], "controllers.yaml": WHEELS}
    text = "controllers: {wheels: {velocity: {left_wheel: 2, right_wheel: 2}}}"
    made = report(tmp_path, files, text, "--engine", engine)
    assert (made["findings"], made["wheels"]) == ([], "passed")
    assert made["ends"] == pytest.approx({"left_wheel": 2.0, "right_wheel": 2.0}, abs=0.1)


DRIVE = "controllers:\n  base:\n    drive: [{for: 2, forward: 0.3}, {for: 2, turn: 0.5}, {for: 1, forward: 0.2}]\n"


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_base_drives_where_it_should(tmp_path: Path, engine: str) -> None:
    made = report(tmp_path, ROVER, DRIVE, "--engine", engine)
    assert (made["base"], made["findings"]) == ("passed", [])
    wrong = {**ROVER, "controllers.yaml": Rover().yaml(separation=2.0)}
    turned = report(tmp_path, wrong, DRIVE, "--engine", engine)
    [turn] = re.findall(r"UC971 line 2: .* the base turns by ([\d.]+) rad, not by 1.00", "\n".join(turned["findings"]))  # type: ignore[arg-type]
    assert 1.5 < float(turn) < 2.1


@needs_an_engine
def test_a_controller_without_a_task_is_tested_as_usual(tmp_path: Path) -> None:
    made = smoke(tmp_path, ROVER, "start: {left_wheel: 1.0}")
    [base] = [each for each in json.loads(made.stdout)["controllers"] if each["name"] == "base"]
    assert base["tested"] == ["started", "drove", "turned"]
