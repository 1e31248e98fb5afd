"""Controllers of separate branches are tested at the same time, those of one branch one after the other."""

from __future__ import annotations

from typing import Any

import pytest

from urdfctl.model.geometry import Pose
from urdfctl.smoke.motion.parallel_groups import groups_of
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily


def hinge(name: str, parent: str, mimic: str = "") -> Hinge:
    made = Hinge(name, "revolute", parent=parent, child=f"{name}_link", pose=Pose(), axis=(0.0, 0.0, 1.0))
    return made._replace(mimic=(mimic, 1.0, 0.0)) if mimic else made


def task(
    name: str, *joints: str, family: MotionFamily = MotionFamily.FORWARD, interface: str = "position"
) -> ControllerTask:
    return ControllerTask(name, family, joints, interface)


LOOP: Any = {"family": MotionFamily.POSITION_PID, "interface": "effort"}
HAND = (hinge("a1", "palm"), hinge("a2", "a1_link"), hinge("b1", "palm"), hinge("b2", "b1_link"))
PALM = Mechanism("palm", {name: LinkBody(name) for name in ("palm", *(h.child for h in HAND))}, HAND)


def names(*tasks: ControllerTask, fixed: bool = True, mechanism: Mechanism = PALM) -> list[list[str]]:
    return [[one.controller for one in group] for group in groups_of(tasks, mechanism, fixed=fixed)]


def test_fingers_move_at_the_same_time_but_not_two_joints_of_one() -> None:
    tasks = [task(name, name, **LOOP) for name in ("a1", "a2", "b1", "b2")]
    assert names(*tasks) == [["a1", "b1"], ["a2", "b2"]]


@pytest.mark.parametrize("interface", ["position", "velocity"])
def test_motors_that_follow_positions_or_velocities_move_at_the_same_time(interface: str) -> None:
    tasks = [task(name, name, interface=interface) for name in ("a1", "a2", "b1")]
    assert names(*tasks, task("a", "a1", interface=interface)) == [["a1", "a2", "b1"], ["a"]]


def test_nothing_moves_together_on_a_base_that_is_not_fixed() -> None:
    assert names(task("a", "a1"), task("b", "b1"), fixed=False) == [["a"], ["b"]]


def test_controllers_that_command_in_different_ways_move_one_after_the_other() -> None:
    assert names(task("a", "a1"), task("b", "b1", interface="velocity")) == [["a"], ["b"]]
    assert names(task("a", "a1"), task("b", "b1", family=MotionFamily.TRAJECTORY)) == [["a"], ["b"]]


def test_pushes_drives_and_controllers_that_only_read_are_alone() -> None:
    assert names(task("a", "a1", interface="effort"), task("b", "b1", interface="effort")) == [["a"], ["b"]]
    assert names(ControllerTask("x", MotionFamily.NOTHING), ControllerTask("y", MotionFamily.NOTHING)) == [["x"], ["y"]]
    drive = task("a", "a1", interface="velocity")._replace(drive=Drive(("a1",)))
    assert names(drive, drive._replace(controller="b", joints=("b1",))) == [["a"], ["b"]]


def test_a_joint_that_mimics_another_moves_with_it() -> None:
    hinges = (*HAND[:3], hinge("b2", "b1_link", mimic="a1"))
    assert names(task("a", "a1", **LOOP), task("b", "b1", **LOOP), mechanism=PALM._replace(hinges=hinges)) == [
        ["a"],
        ["b"],
    ]


def test_a_motor_moves_the_joints_that_mimic_its_joint_too() -> None:
    hinges = (*HAND[:3], hinge("b2", "b1_link", mimic="a1"))
    palm = PALM._replace(hinges=hinges)
    assert names(task("a", "a1"), task("b", "b2"), mechanism=palm) == [["a"], ["b"]]
    assert names(task("a", "a2"), task("b", "b2"), mechanism=palm) == [["a", "b"]]
