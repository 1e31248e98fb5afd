"""The nearest name."""

from __future__ import annotations

import difflib

import pytest

from urdfctl.names import nearest


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
