"""Copies, backups and outputs of calibrations are no robots, unless the user names them or there is nothing else."""

from __future__ import annotations

import json

import pytest
from folder import Folder

ROBOT = (
    "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='fixed'>"
    "<parent link='a'/><child link='b'/></joint></robot>"
)


def robots(folder: Folder, *words: str) -> list[str]:
    ran = folder.run("lint", *words, "--format", "json", "--exit-zero")
    return [target["robot"] for target in json.loads(ran.stdout)["targets"]]


@pytest.mark.parametrize(
    "aside",
    [
        "urdf/arm(1).urdf",
        "urdf/arm (2).urdf",
        "urdf/arm - Copy.urdf",
        "urdf/arm copy 2.urdf",
        "urdf/arm_backup.urdf",
        "urdf/arm.orig.urdf",
        "urdf/arm_old.urdf",
        "urdf/arm_2023-01-31.urdf",
        "urdf/arm_20230131-1200.urdf",
        "urdf/arm_calibrated.urdf",
        "urdf/uncalibrated_arm.urdf",
        "calibration_2020.urdf",
        "backup/other.urdf",
        "urdf/Discard/other.urdf",
    ],
)
def test_what_is_kept_aside_is_no_robot(aside: str, folder: Folder) -> None:
    folder.write({"urdf/arm.urdf": ROBOT, aside: ROBOT})
    assert robots(folder, ".") == ["urdf/arm.urdf"]


@pytest.mark.parametrize(
    "other", ["urdf/hand_old.urdf", "urdf/arm2.urdf", "urdf/arm_left.urdf", "urdf/bold.urdf", "oldest/arm.urdf"]
)
def test_what_is_no_copy_of_a_file_beside_it_is_a_robot(other: str, folder: Folder) -> None:
    folder.write({"urdf/arm.urdf": ROBOT, other: ROBOT})
    assert set(robots(folder, ".")) == {"urdf/arm.urdf", other}


def test_a_backup_is_a_robot_if_the_user_names_it_or_there_is_nothing_else(folder: Folder) -> None:
    folder.write({"urdf/arm.urdf": ROBOT, "backup/arm.urdf": ROBOT})
    assert robots(folder, "backup/arm.urdf") == ["backup/arm.urdf"]
    assert robots(folder, "backup") == ["backup/arm.urdf"]
