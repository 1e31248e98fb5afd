"""`urdfctl explain` of pasted messages and of logs."""

from __future__ import annotations

import json
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from folder import CHECKOUT, Folder
from typer.testing import CliRunner, Result

from urdfctl import REPOSITORY, __version__
from urdfctl.commands.app import app
from urdfctl.errors import UserError

LINE = "[ERROR] [1623.45, 0.2]: No valid hardware interface element found in joint 'elbow'."
LOG = f"""\
[INFO] [1623.40]: hello
{LINE}
[ERROR] [1623.46]: No p gain specified for pid.  Namespace: /gazebo_ros_control/pid_gains/elbow
[ERROR] [1623.47]: the flux capacitor is empty
{LINE.replace("elbow", "wrist")}
[FATAL] [1623.48]: Could not initialize robot simulation interface
"""
NOTHING = "nothing to explain; pass a rule code, a line of a log in quotes, or a log"


def command(*words: str, given: str = "") -> Result:
    """Run the command in this process with the given standard input; exceptions are raised."""
    return CliRunner().invoke(app, ["explain", *words], input=given, catch_exceptions=False)


def test_a_pasted_line_is_explained_with_its_names_causes_rules_and_authority() -> None:
    ran = command(LINE)
    assert ran.exit_code == 0
    assert ran.stdout.startswith("No valid hardware interface element found in joint 'elbow'.\n  Joint 'elbow' is in a")
    for part in (
        "Causes, most likely first:\n    1. ",
        "UC201",
        "Fix: Put <hardwareInterface>",
        "Printed by ros_control's transmission parser (indigo to noetic)",
        "urdfctl lint robot.xacro  finds UC201",
    ):
        assert part in ran.stdout


def test_a_pasted_line_need_not_be_quoted() -> None:
    assert command(*LINE.split()).stdout == command(LINE).stdout


@pytest.mark.parametrize("words", [[], ["-"], ["gazebo.log"]])
def test_a_log_is_explained_from_a_pipe_or_a_file(folder: Folder, words: list[str]) -> None:
    folder.write({"gazebo.log": LOG})
    ran = command(*words, given=LOG)
    assert ran.exit_code == 0
    text = ran.stdout
    assert text.startswith("6 lines: 1 failure, 1 consequence, 1 harmless\n\n== Failures ==\n\nline 2 (2 times, also")
    places = [text.index(part) for part in ("line 2 ", "line 6: ", "line 4: the flux", "line 3: No p gain", "Next:")]
    assert places == sorted(places)


def test_a_log_as_json_contains_everything() -> None:
    log = json.loads(command("-", "--format", "json", given=LOG).stdout)
    assert (log["version"], log["tool"]["version"], log["lines"], log["complete"]) == (1, __version__, 6, True)
    first = log["messages"][0]
    assert (first["id"], first["kind"], first["line"], first["count"]) == (
        "no-hardware-interface-in-joint",
        "failure",
        2,
        2,
    )
    assert first["values"] == [{"joint": "elbow"}, {"joint": "wrist"}]
    assert first["causes"][0]["rules"] == [{"code": "UC201", "name": "transmission-joint-without-interface"}]
    assert [message["kind"] for message in log["messages"]] == ["failure", "consequence", "harmless"]
    assert log["unknown"] == [
        {"line": 4, "count": 1, "text": "the flux capacitor is empty", "level": "error", "nearest": None}
    ]
    assert log["next"][0].startswith("urdfctl lint robot.xacro")


def test_a_rule_as_json_has_the_same_form_as_in_the_list_of_rules() -> None:
    rule = json.loads(command("UC201", "--format", "json").stdout)
    assert (rule["code"], rule["name"]) == ("UC201", "transmission-joint-without-interface")


def test_an_unknown_text_has_status_1_and_can_be_reported() -> None:
    ran = command("foo bar baz")
    assert ran.exit_code == 1
    assert ran.stdout.startswith("urdfctl does not know this message:\nfoo bar baz\n\nTo have it explained, report it")
    assert f"{REPOSITORY}/issues" in ran.stdout


@pytest.mark.parametrize(
    ("text", "debian"),
    [
        ("package 'robot_teleop' is not found", "ros-$ROS_DISTRO-robot-teleop"),
        ("[rospack] Error: package 'robot_\nteleop' not found", "ros-$ROS_DISTRO-robot-teleop"),
        ("Resource not found: robot_\n   teleop\nROS path [0]=/opt/ros/melodic/share/ros", "ros-melodic-robot-teleop"),
        ('Could not find a package configuration file provided by "robot_teleop"', "ros-$ROS_DISTRO-robot-teleop"),
    ],
)
def test_a_missing_package_is_named_as_it_is_and_as_debian_names_it(text: str, debian: str) -> None:
    said = " ".join(command(text).stdout.split())
    assert "ackage 'robot_teleop'" in said
    assert f"sudo apt install {debian}" in said


def test_the_distro_of_the_user_names_the_debian_package() -> None:
    assert "ros-kinetic-robot-teleop" in command("--distro", "kinetic", "package 'robot_teleop' not found").stdout
    with pytest.raises(UserError, match="unknown distro 'kinetik'; did you mean 'kinetic'"):
        command("--distro", "kinetik", "package 'robot_teleop' not found")


def test_a_rule_says_what_is_printed_because_of_its_fault() -> None:
    printed = "No valid hardware interface element found in joint 'JOINT'."
    assert f"\n  {printed} (ros_control's transmission parser)\n" in command("UC201").stdout
    assert printed in json.loads(command("UC201", "--format", "json").stdout)["prints"]
    assert "Printed in the log" not in command("UC016").stdout


def test_the_nearest_message_is_offered() -> None:
    text = command("no valid hardware interface elements found for joint 'elbow'").stdout
    assert "did you mean: No valid hardware interface element found in joint '…'." in text


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ([], NOTHING),
        (["-"], NOTHING),
        ([""], NOTHING),
        (["  "], NOTHING),
        (["logs/gazebo.log"], "file 'logs/gazebo.log' does not exist"),
        ([LINE, "--format", "yaml"], "unknown format 'yaml'; known are text, json"),
    ],
)
def test_nothing_to_explain_is_the_user_s_error(words: list[str], error: str) -> None:
    with pytest.raises(UserError) as nothing:
        command(*words)
    assert str(nothing.value).startswith(error)


def test_for_a_family_the_command_that_lists_its_rules_is_shown(folder: Folder) -> None:
    error = "urdfctl: unknown rule 'uc2'. To list the rules with this prefix, run urdfctl rules --select UC2\n"
    assert folder.run("explain", "uc2").stderr == error


def test_an_empty_log_has_status_2(folder: Folder) -> None:
    folder.write({"empty.log": ""})
    ran = folder.run("explain", "empty.log")
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr.startswith(f"urdfctl: {NOTHING}")
    assert ran.stderr.count("\n") == 1


def test_control_characters_of_a_log_do_not_reach_the_terminal() -> None:
    ran = command(
        "-", given="[ERROR] \x07\x1b]0;title\x07bad \x9b31m thing\n" + LINE.replace("elbow", "el\x08bow\u202e")
    )
    assert ran.stdout.isprintable() or all(c.isprintable() or c == "\n" for c in ran.stdout)
    assert "joint 'el\\x08bow\\u202e'" in ran.stdout


def test_a_log_of_any_encoding_is_read(folder: Folder) -> None:
    with open("junk.log", "wb") as file:
        file.write(b"\xff\xfe\x00\n" + LINE.encode() + b"\xe4\n")
    assert "joint 'elbow'" in folder.run("explain", "junk.log").stdout


def test_a_closed_pipe_ends_it_quietly(folder: Folder) -> None:
    folder.write({"gazebo.log": LOG})
    words = f'"{sys.executable}" -m urdfctl explain gazebo.log | head -1'
    ran = subprocess.run(["sh", "-c", words], capture_output=True, text=True, check=False, env=dict(os.environ))
    assert (ran.stdout.count("\n"), ran.stderr) == (1, "")


@pytest.mark.parametrize("words", ["UC201", "UC201 --format json", "gazebo.log"])
def test_an_explanation_is_written_to_a_file(words: str, folder: Folder) -> None:
    folder.write({"gazebo.log": "No p gain specified for pid.\n"})
    shown = folder.run("explain", *words.split())
    written = folder.run("explain", *words.split(), "-o", "made.txt")
    assert (written.returncode, written.stdout) == (0, "")
    assert (folder.path / "made.txt").read_text(encoding="utf-8") == shown.stdout != ""


def test_a_cause_that_has_a_safe_fix_leads_to_the_command_that_makes_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copytree(CHECKOUT / "samples/broken/mybot", tmp_path / "mybot")
    monkeypatch.chdir(tmp_path / "mybot")
    message = "No valid hardware interface element found in joint 'left_wheel_joint'."
    repair = "urdfctl lint . --fix --select UC201"
    assert f"  {repair}  repairs what caused it" in command(message, "--in", ".").stdout
    assert CliRunner().invoke(app, shlex.split(repair)[1:]).exit_code == 0
    assert "--fix" not in command(message, "--in", ".").stdout
