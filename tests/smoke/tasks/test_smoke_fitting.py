"""Whether a user's task fits a controller and its joints, and what is said of its line in the file if it does not."""

from __future__ import annotations

import pytest

from urdfctl.model.geometry import Pose
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily
from urdfctl.smoke.tasks.task_file import TaskFile, TaskStep, UserTask
from urdfctl.smoke.tasks.task_file_check import kinds_of, misfits

HELD = ("target", "trajectory")
WHEELS = Drive(("l",), ("r",), radius=0.1, separation=0.4)


@pytest.mark.parametrize(
    ("family", "interface", "drive", "kinds"),
    [
        (MotionFamily.FORWARD, "position", None, HELD),
        (MotionFamily.FORWARD, "velocity", None, ("velocity",)),
        (MotionFamily.FORWARD, "effort", None, ()),
        (MotionFamily.POSITION_PID, "effort", None, HELD),
        (MotionFamily.POSITION_PID, "velocity", None, HELD),
        (MotionFamily.TRAJECTORY, "position", None, HELD),
        (MotionFamily.TRAJECTORY, "velocity", None, HELD),
        (MotionFamily.VELOCITY_PID, "effort", None, ("velocity",)),
        (MotionFamily.VELOCITY_PID, "position", None, ("velocity",)),
        (MotionFamily.NOTHING, "position", None, ()),
        (MotionFamily.NOTHING, "velocity", None, ()),
        (MotionFamily.DIFFERENTIAL, "velocity", WHEELS, ("drive",)),
        (MotionFamily.FORWARD, "velocity", WHEELS._replace(is_inferred=True), ("velocity",)),
    ],
)
def test_a_controller_can_hold_turn_or_drive(
    family: MotionFamily, interface: str, drive: Drive | None, kinds: tuple[str, ...]
) -> None:
    assert kinds_of(ControllerTask("arm", family, ("j",), interface, drive=drive)) == kinds


def told(start: tuple[tuple[str, float], ...] = (), velocity: float = 2.0, **fields: object) -> list[str]:
    """Return what is said of a start pose, and of a task for joint 'j', which has limits of -1 and 1 rad."""
    made = Hinge("j", "revolute", parent="base", child="arm", pose=Pose(), axis=(0.0, 0.0, 1.0))
    hinge = made._replace(lower=-1.0, upper=1.0, velocity=velocity)
    others = (
        hinge._replace(name="mount", type="fixed", child="mount"),
        hinge._replace(name="finger", mimic=("j", 1.0, 0.0), child="finger"),
        hinge._replace(name="wheel", type="continuous", child="wheel"),
    )
    bodies = {name: LinkBody(name) for name in ("base", "arm", "mount", "finger", "wheel")}
    given = {"controller": "arm", "kind": "target", "joint": "j", "value": 0.5, **fields}
    step = TaskStep(1.0, ((str(given["joint"]), float(str(given["value"]))),), 7)
    user_task = UserTask(str(given["controller"]), str(given["kind"]), (step,), (0, 0))
    file = TaskFile("tasks.yaml", "", tuple((*pair, 3) for pair in start), (user_task,))
    interface = "velocity" if given["kind"] == "velocity" else "position"
    task = ControllerTask("arm", MotionFamily.FORWARD, ("j", "wheel"), interface)
    mechanism = Mechanism("base", bodies, (hinge, *others))
    return [f"{one.line}: {one.message}" for one in misfits(file, mechanism, [task], ["arm", "stopped"])]


@pytest.mark.parametrize("place", [-1.0, 0.0, 1.0])
def test_a_target_within_the_limits_fits(place: float) -> None:
    assert told((("j", place), ("wheel", 7.0)), value=place) == []
    assert told(joint="wheel", value=7.0) == []


@pytest.mark.parametrize("place", [-1.1, 1.1])
def test_a_target_beyond_the_limits_does_not_fit(place: float) -> None:
    outside = f"{place:g} rad is outside the limits of joint 'j', -1 to 1 rad"
    assert told((("j", place),), value=place) == [f"3: {outside}", f"7: {outside}"]


@pytest.mark.parametrize("joint", ["j", "wheel"])
def test_a_velocity_beyond_the_limit_does_not_fit(joint: str) -> None:
    assert told(kind="velocity", joint=joint, value=-2.0) == []
    assert told(kind="velocity", joint=joint, value=-2.1) == [
        f"7: -2.1 rad/s is outside the limits of joint '{joint}', -2 to 2 rad/s"
    ]


def test_a_joint_without_a_velocity_limit_may_turn_at_any_speed() -> None:
    assert told(kind="velocity", value=50.0, velocity=0.0) == []


@pytest.mark.parametrize("name", ["mount", "finger"])
def test_a_start_pose_moves_only_joints_that_move_by_themselves(name: str) -> None:
    assert told(((name, 0.1),)) == [f"3: joint '{name}' does not move by itself"]


def test_a_joint_that_the_controller_does_not_command_does_not_fit() -> None:
    assert told(joint="finger") == ["7: controller 'arm' does not command joint 'finger'"]


def test_a_controller_that_was_stopped_before_is_no_misfit_but_an_unknown_one_is() -> None:
    assert told(controller="stopped") == []
    assert told(controller="hand")[0].endswith("no robot has a controller 'hand'")
