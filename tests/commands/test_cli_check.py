"""`urdfctl check`: lint and smoke with one report and one exit status."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from folder import CHECKOUT, Folder
from generating import command

NO_ENGINE = ("--engine", "none")


@pytest.fixture
def picker(folder: Folder) -> Path:
    """The sample, in the current folder."""
    shutil.copytree(CHECKOUT / "samples/picker", folder.path, dirs_exist_ok=True)
    return folder.path


def replace(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))


def test_a_sound_robot_passes_with_its_controllers_listed(picker: Path) -> None:
    ran = command("check", *NO_ENGINE)
    assert ran.returncode == 0, ran.stdout
    assert "arm_controller" in ran.stdout
    assert "no findings in" in ran.stdout


def test_what_lint_and_smoke_both_find_is_reported_once(picker: Path) -> None:
    replace(picker / "config/controllers.yaml", "joints: [turn, shoulder,", "joints: [turn, shuolder,")
    ran = command("check", *NO_ENGINE, "--format", "json")
    report = json.loads(ran.stdout)
    found = [one["code"] for one in report["findings"] if one["severity"] == "error"]
    assert (ran.returncode, found.count("UC440")) == (1, 1)
    assert "UC905" not in found
    assert [one["verdict"] for one in report["controllers"]].count("failed") == 1


def test_a_controller_that_fails_by_a_consequence_of_what_lint_reports_is_no_finding_of_its_own(picker: Path) -> None:
    replace(picker / "urdf/ros2_control.xacro", '<joint name="elbow">', '<joint name="elbwo">')
    found = json.loads(command("check", *NO_ENGINE, "--format", "json").stdout)["findings"]
    assert [one["code"] for one in found if one["severity"] == "error"] == ["UC312"]


def test_what_both_measure_in_the_same_words_is_reported_once(picker: Path) -> None:
    replace(picker / "urdf/parts.xacro", '<origin rpy="${pi / 2} 0 0"/>', '<origin rpy="90 0 0"/>')
    found = json.loads(command("check", *NO_ENGINE, "--format", "json").stdout)["findings"]
    turned = [one for one in found if "most likely degrees" in one["message"]]
    assert {one["code"] for one in turned} == {"UC168"}
    assert turned[0]["fix"]["edits"][0]["text"] == "${radians(90)} 0 0"


def test_what_only_smoke_finds_fails_the_run(picker: Path) -> None:
    replace(picker / "config/joint_limits.yaml", "max_effort: 40.0", "max_effort: 0.4")
    replace(picker / "config/joint_limits.yaml", "max_effort: 40.0", "max_effort: 0.4")
    assert command("lint", "--fail-on", "warning").returncode == 0
    ran = command("check", *NO_ENGINE, "--fail-on", "warning")
    assert (ran.returncode, "UC950" in ran.stdout) == (1, True)


def test_files_without_a_robot_are_only_linted(folder: Folder) -> None:
    folder.write({"controllers.yaml": "controller_manager:\n  ros__parameters:\n    update_rate: 100\n"})
    ran = command("check", *NO_ENGINE)
    assert ran.returncode == 0, ran.stderr
    assert "nothing was tested" in ran.stdout
