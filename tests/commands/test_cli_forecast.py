"""`urdfctl explain --in FOLDER` without a log lists what is expected to be printed at start."""

from __future__ import annotations

import json
import shutil
from typing import Any

import pytest
from folder import CHECKOUT, Folder
from generating import command


@pytest.fixture
def picker(folder: Folder) -> Folder:
    """The sample, in the current folder."""
    shutil.copytree(CHECKOUT / "samples/picker", folder.path, dirs_exist_ok=True)
    return folder


def starts() -> list[dict[str, Any]]:
    ran = command("explain", "--in", ".", "--format", "json")
    assert ran.returncode == 0, ran.stderr
    found: list[dict[str, Any]] = json.loads(ran.stdout)["starts"]
    return found


def test_a_sound_robot_is_expected_to_print_nothing(picker: Folder) -> None:
    assert [one["messages"] for one in starts()] == [[], []]
    assert "no message of an error is expected" in command("explain", "--in", ".").stdout


def test_each_launch_file_lists_its_messages_with_the_line_of_the_cause(picker: Folder) -> None:
    path = picker.path / "config/controllers.yaml"
    path.write_text(path.read_text().replace("diff_drive_controller/Diff", "diff_drive_controller/Dif"))
    [start] = [one for one in starts() if one["launch"] == "launch/moveit.launch.py"]
    [message] = [one for one in start["messages"] if one["rule"] == "UC421"]
    assert "'diff_drive_controller/DifDriveController') not found" in message["text"]
    assert (message["file"], message["line"]) == ("config/controllers.yaml", 15)
    shown = command("explain", "--in", ".").stdout
    assert "launch/moveit.launch.py (jazzy) is expected to print:" in shown
    assert "config/controllers.yaml:15:13: UC421" in shown


def test_a_folder_without_a_robot_has_nothing_to_expect(folder: Folder) -> None:
    folder.write({"c.yaml": "controller_manager:\n  ros__parameters: {update_rate: 100}\n"})
    assert "no robot found in ." in command("explain", "--in", ".").stdout
