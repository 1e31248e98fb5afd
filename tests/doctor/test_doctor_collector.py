"""The collector asks a running system; here a stand-in for the Python of ROS 2 answers from a recording."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from fake_ros import write_fake_ros
from folder import Folder

import urdfctl
from urdfctl.rules.running.samples import FILES, sound

COLLECTOR = Path(urdfctl.__file__).parent / "doctor/collector.py"


@pytest.fixture
def system(folder: Folder) -> dict[str, str]:
    """The environment of a system that runs as the files say."""
    write_fake_ros(folder.path / "ros")
    recording = sound()
    recording["parameters"]["/head"]["values"] |= {"robot_serial": "A1", "rate": 2.5}
    folder.write({**FILES, "system.json": json.dumps(recording)})
    fake = {
        "PYTHONPATH": str(folder.path / "ros"),
        "FAKE_SYSTEM": str(folder.path / "system.json"),
        "ROS_DISTRO": "jazzy",
    }
    return {**os.environ, **fake}


def recorded(environ: dict[str, str], *words: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(COLLECTOR), "--seconds", "0.1", *words]
    return subprocess.run(command, env=environ, capture_output=True, text=True, check=False)


def test_what_the_collector_records_of_a_sound_system_is_sound_for_the_doctor(
    folder: Folder, system: dict[str, str]
) -> None:
    ran = recorded(system)
    assert (ran.returncode, ran.stderr) == (0, "")
    folder.write({"snapshot.json": ran.stdout})
    told = folder.run("doctor", "snapshot.json")
    assert (told.returncode, told.stdout[:4]) == (0, "ok: "), told.stdout


def test_the_collector_records_the_graph_the_answers_and_the_messages(system: dict[str, str]) -> None:
    found, wanted = json.loads(recorded(system).stdout), sound()
    assert found["nodes"] == wanted["nodes"]
    assert [topic["name"] for topic in found["topics"]] == [topic["name"] for topic in wanted["topics"]]
    ends = found["topics"][2]["publishers"]
    assert [(end["node"], end["qos"]["durability"]) for end in ends] == [("robot_state_publisher", "transient_local")]
    assert found["controller_managers"] == wanted["controller_managers"]
    assert found["joint_states"]["/joint_states"]["name_lists"] == [["pan", "tilt"]]
    assert found["robot_description"] == wanted["robot_description"]
    assert found["clock"] == {"error": "no publisher"}


def test_private_values_are_left_out_unless_they_are_asked_for(system: dict[str, str]) -> None:
    values = json.loads(recorded(system).stdout)["parameters"]["/head"]["values"]
    assert (values["robot_serial"], values["rate"], values["joints"]) == ("left out", 2.5, ["pan", "tilt"])
    assert json.loads(recorded(system, "--all").stdout)["parameters"]["/head"]["values"]["robot_serial"] == "A1"


def test_what_does_not_answer_is_an_error_in_the_recording_and_costs_half_a_second_each(system: dict[str, str]) -> None:
    began = time.monotonic()
    found = json.loads(recorded({**system, "FAKE_MUTE": "1"}).stdout)
    assert time.monotonic() - began < 20  # of five questions; a generous limit, for a busy machine
    assert found["controller_managers"]["/controller_manager"] == {
        "list_controllers": {"error": "service not available"}
    }
    assert found["parameters"]["/head"] == {"error": "service not available"}


def test_without_a_recording_the_doctor_records_the_system_that_runs_here(
    folder: Folder, system: dict[str, str]
) -> None:
    ran = folder.run("doctor", "--seconds", "0.1", "--snapshot", "now.json", environ=dict(system))
    assert (ran.returncode, ran.stdout[:4]) == (0, "ok: "), ran.stderr
    assert json.loads((folder.path / "now.json").read_text())["recorded"]["distro"] == "jazzy"


def test_without_ros_and_without_a_recording_the_way_out_is_said(folder: Folder) -> None:
    folder.write(FILES)
    ran = folder.run("doctor", environ={"PYTHONPATH": None})
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr.startswith("urdfctl: ROS 2 is not sourced in this Python (")
    assert ran.stderr.endswith("source ROS, or name a recording: urdfctl doctor SNAPSHOT.json\n")
