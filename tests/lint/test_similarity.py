"""The nearest name."""

from __future__ import annotations

import difflib

import pytest

from urdfctl.names import fuller, is_only_slip, nearest


def test_the_last_name_of_those_that_are_equally_similar_is_the_nearest() -> None:
    known = ["wrist_1_joint", "wrist_2_joint", "wrist_3_joint", "elbow_joint"]
    assert [nearest("wrist_joint", known)] == difflib.get_close_matches("wrist_joint", known, n=1, cutoff=0.8)
    assert nearest("wrist_joint", known) == "wrist_3_joint"
    assert nearest("gripper", known) is None


@pytest.mark.parametrize(
    ("unknown", "meant"),
    [
        ("mobile_px100/ar_tag_link", None),
        ("mobile_px100/shoulder_lnk", "mobile_px100/shoulder_link"),
        ("mobile_px100/ee_arm_lnik", "mobile_px100/ee_arm_link"),
        ("mobile_px10/ee_arm_link", "mobile_px100/ee_arm_link"),
    ],
)
def test_a_namespace_before_most_names_makes_none_of_them_similar(unknown: str, meant: str | None) -> None:
    links = [f"mobile_px100/{link}" for link in ("base_link", "shoulder_link", "upper_arm_link", "ee_arm_link")]
    assert nearest(unknown, [*links, "world"]) == meant


@pytest.mark.parametrize(
    ("unknown", "known", "meant"),
    [
        ("wheel_lf", ["wheel_fl", "wheel_rl", "wheel_rr"], "wheel_fl"),
        ("joint_wirst", ["joint_wrist", "joint_elbow", "joint_base"], "joint_wrist"),
        ("left_shoulder_link", ["left_elbow_link", "left_hand_link", "left_shouldr_link"], "left_shouldr_link"),
    ],
)
def test_a_slip_after_a_shared_prefix_is_still_found(unknown: str, known: list[str], meant: str) -> None:
    assert nearest(unknown, known) == meant


def test_another_style_of_the_same_name_is_the_nearest() -> None:
    assert nearest("pid.iClamp", ["pid.p", "pid.i", "pid.i_clamp", "pid.i_clamp_max"]) == "pid.i_clamp"


@pytest.mark.parametrize(
    ("name", "known", "meant"),
    [
        ("left_wheel_jont", ["left_wheel_joint", "right_wheel_joint"], "left_wheel_joint"),
        ("lft_wheel_joint", ["left_wheel_joint", "right_wheel_joint"], "left_wheel_joint"),
        ("left_wheel_joint", ["right_wheel_joint"], None),
        ("xarm_description", ["kaair_description", "kaair_bringup"], None),
        ("custom_sawyer_description", ["sawyer_description", "sawyer_bringup"], "sawyer_description"),
        ("mybott_description", ["mybot_description", "mybot_bringup"], "mybot_description"),
        ("linear.x.max_acceleration", ["linear.y.max_acceleration"], None),
        ("LHipYaw", ["RHipYaw", "LHipRoll"], None),
        ("joint_7", ["joint_5", "joint_6"], None),
        ("joint_66", ["joint_5", "joint_6"], "joint_6"),
        ("max_velocity", ["min_velocity", "max_effort"], None),
    ],
)
def test_a_name_of_another_side_axis_quantity_or_number_is_not_meant(
    name: str, known: list[str], meant: str | None
) -> None:
    assert nearest(name, known) == meant


def test_the_only_name_with_all_words_of_another_one_and_more_is_meant() -> None:
    controllers = ["joint1_position_controller", "joint2_position_controller", "states"]
    assert fuller("joint1_controller", controllers) == "joint1_position_controller"
    assert fuller("joint_controller", ["left_joint_controller", "right_joint_controller"]) is None
    assert fuller("states", ["joint_states"]) is None
    assert fuller("controller_joint1", controllers) is None


def test_a_slip_is_sure_only_if_no_third_name_comes_near() -> None:
    assert is_only_slip("tilr", "tilt", ["pan", "tilt"])
    assert not is_only_slip("tilr", "tilt", ["tile", "tilt"])
    assert not is_only_slip("titlr", "tilt", ["pan", "tilt"])
