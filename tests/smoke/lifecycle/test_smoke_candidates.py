"""Controllers in each possible ROS distro: what all agree on, and what depends on it."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from smoking import smoked, target_of, verdicts

from urdfctl.model.stage import Stage
from urdfctl.smoke.lifecycle import possible_distros
from urdfctl.smoke.lifecycle.controller_manager import ControllerLifecycle, Refusal, RobotLifecycle
from urdfctl.smoke.lifecycle.possible_distros import fates_in_words, lifecycle_of, result_without_motion
from urdfctl.smoke.results import Trouble, Verdict

WRONG = Refusal(Stage.CONFIGURE, "a parameter is missing")
UNKNOWN = Refusal(Stage.LOAD, "its type does not exist")


def way(name: str, refusal: Refusal | None = None) -> ControllerLifecycle:
    configured: Any = SimpleNamespace(controller=SimpleNamespace(type=None))
    return ControllerLifecycle(configured, name, refusal)


def lifecycle(
    distro: str,
    *ways: ControllerLifecycle,
    rejected: str = "",
    troubles: tuple[Trouble, ...] = (),
    detail: str = " in arm.yaml",
) -> RobotLifecycle:
    own = tuple(
        Trouble("UC904", f"controller:{each.name}", f"{each.name} fails: {each.refusal.why}{detail}", each.name)
        for each in ways
        if each.refusal
    )
    return RobotLifecycle(distro, ways, (*own, *troubles), {}, rejected)


def agreed(monkeypatch: pytest.MonkeyPatch, *lifecycles: RobotLifecycle) -> RobotLifecycle:
    """Return what several distros come to."""
    by_distro = {each.distro: each for each in lifecycles}
    monkeypatch.setattr(possible_distros, "errors_by_distro", lambda _: [(distro, []) for distro in by_distro])
    monkeypatch.setattr(possible_distros, "lifecycle_in", lambda _project, distro, _errors: by_distro[distro])
    seen: Any = SimpleNamespace(project=None)
    return lifecycle_of(seen)


def fates(made: RobotLifecycle) -> dict[str, dict[str, str]]:
    return {each.name: dict(each.by_distro) for each in made.controllers if each.by_distro}


def test_one_distro_is_taken_as_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    only = lifecycle("jazzy", way("arm", WRONG))
    assert agreed(monkeypatch, only) is only


def test_the_newest_of_the_distros_in_which_most_controllers_start_moves(monkeypatch: pytest.MonkeyPatch) -> None:
    both = way("arm"), way("hand")
    made = agreed(
        monkeypatch,
        lifecycle("humble", *both),
        lifecycle("jazzy", *both),
        lifecycle("kilted", way("arm"), way("hand", WRONG)),
    )
    assert made.distro == "jazzy"


def test_what_all_distros_agree_on_is_certain(monkeypatch: pytest.MonkeyPatch) -> None:
    made = agreed(
        monkeypatch,
        lifecycle("humble", way("arm"), way("hand", WRONG)),
        lifecycle("jazzy", way("arm"), way("hand", WRONG)),
    )
    assert fates(made) == {}
    assert [(one.code, one.controller) for one in made.troubles] == [("UC904", "hand")]


def test_a_controller_that_fails_everywhere_for_another_reason_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    made = agreed(monkeypatch, lifecycle("humble", way("arm", WRONG)), lifecycle("jazzy", way("arm", UNKNOWN)))
    assert fates(made) == {}
    assert [one.code for one in made.troubles] == ["UC904"]


def test_what_differs_is_a_warning_that_names_each_distro(monkeypatch: pytest.MonkeyPatch) -> None:
    made = agreed(
        monkeypatch,
        lifecycle("humble", way("arm"), way("hand"), way("foot")),
        lifecycle("jazzy", way("arm"), way("hand", WRONG), way("foot", WRONG)),
    )
    fate = {"humble": "becomes active", "jazzy": "cannot be configured: a parameter is missing"}
    assert fates(made) == {"hand": fate, "foot": fate}
    [trouble] = made.troubles
    assert (trouble.code, trouble.controller) == ("UC970", "hand")
    assert trouble.notes == ("hand fails: a parameter is missing in arm.yaml", "the same holds for 'foot'")


@pytest.mark.parametrize(("rejected_too", "codes"), [("the hardware is rejected", ["UC902"]), ("", [])])
def test_what_rejects_the_robot_counts_if_all_distros_reject_it(
    rejected_too: str, codes: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    fault = Trouble("UC902", "robot", "the hardware is rejected", None)
    humble = lifecycle("humble", way("arm"), rejected=rejected_too)
    made = agreed(
        monkeypatch, humble, lifecycle("jazzy", way("arm"), rejected="the hardware is rejected", troubles=(fault,))
    )
    assert [one.code for one in made.troubles] == codes


def test_the_cause_of_a_difference_is_that_of_the_controller_before_that_of_the_robot(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    of_robot = Trouble("UC902", "robot", "the hardware is rejected", None)
    jazzy = lifecycle("jazzy", way("arm", WRONG))
    jazzy = jazzy._replace(troubles=(of_robot, *jazzy.troubles))
    [trouble] = agreed(monkeypatch, lifecycle("humble", way("arm")), jazzy).troubles
    assert trouble.notes == ("arm fails: a parameter is missing in arm.yaml",)


def test_a_cause_that_says_no_more_than_the_fates_is_not_repeated(monkeypatch: pytest.MonkeyPatch) -> None:
    [trouble] = agreed(
        monkeypatch, lifecycle("humble", way("arm")), lifecycle("jazzy", way("arm", WRONG), detail="")
    ).troubles
    assert trouble.notes == ()


def test_distros_in_which_a_type_does_not_exist_share_a_fate(monkeypatch: pytest.MonkeyPatch) -> None:
    gone = {
        distro: way("arm", Refusal(Stage.LOAD, f"type 'a/B' does not exist in {distro}, only in foxy; use 'a/C'"))
        for distro in ("galactic", "humble", "iron")
    }
    made = agreed(
        monkeypatch, lifecycle("foxy", way("arm")), *(lifecycle(distro, each) for distro, each in gone.items())
    )
    assert fates_in_words(fates(made)["arm"]) == (
        "it becomes active in foxy; it cannot be loaded in galactic to iron: "
        "type 'a/B' does not exist there, only in foxy; use 'a/C'"
    )


def test_distros_of_the_same_fate_are_joined_and_the_best_fate_comes_first() -> None:
    told = fates_in_words({"humble": "cannot be loaded: x", "jazzy": "becomes active", "kilted": "cannot be loaded: x"})
    assert told == "it becomes active in jazzy; it cannot be loaded in humble, kilted: x"


@pytest.mark.parametrize(
    ("fate", "stage"),
    [
        ("cannot be loaded: x", Stage.LOAD),
        ("cannot be configured: x", Stage.CONFIGURE),
        ("cannot be activated: x", Stage.ACTIVATE),
    ],
)
def test_a_controller_that_depends_on_the_distro_is_warned_at_the_first_stage_that_fails(
    fate: str, stage: Stage
) -> None:
    by_distro = {"humble": "becomes active", "iron": "cannot be activated: y", "jazzy": fate}
    made = result_without_motion(way("arm")._replace(by_distro=by_distro))
    assert (made.verdict, made.stage) == (Verdict.WARNED, stage)
    assert result_without_motion(way("arm")).verdict is Verdict.SKIPPED


ELBOW = """
<robot name="arm">
  <link name="base"/>
  <link name="fore">
    <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
  </link>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="fore"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="5" velocity="1"/>
  </joint>
  <transmission name="elbow_trans">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
    <actuator name="elbow_motor"/>
  </transmission>
  <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
</robot>
"""
"""Gazebo takes the interface with its prefix from kinetic on."""


def test_what_only_distros_of_long_ago_reject_is_no_warning(tmp_path: Path) -> None:
    target = target_of(
        tmp_path,
        {"r.urdf": ELBOW, "c.yaml": "mover: {type: position_controllers/JointPositionController, joint: elbow}"},
    )
    assert verdicts(smoked(target)) == {"mover": "skipped activate"}
    assert verdicts(smoked(target, distro="indigo")) == {"mover": "failed activate"}
