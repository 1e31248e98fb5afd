"""The collector asks a running system; here a stand-in for the Python of ROS 2 answers from a recording."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import jsonschema
import pytest
from fake_ros import write_fake_ros
from folder import CHECKOUT, Folder

import urdfctl
from urdfctl.rules.running.samples import FILES, sound

LONGEST = 5.0
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


def test_a_recording_has_the_form_of_its_schema(system: dict[str, str]) -> None:
    schema = json.loads((COLLECTOR.parent / "recording.schema.json").read_text())
    for environ in (system, {**system, "FAKE_MUTE": "1"}):
        jsonschema.validate(json.loads(recorded(environ).stdout), schema)
    jsonschema.validate(sound(), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**sound(), "nodes": [{"name": "head"}]}, schema)


def test_watching_ends_when_nothing_is_wrong_and_tells_what_was(folder: Folder, system: dict[str, str]) -> None:
    file = Path(system["FAKE_SYSTEM"])
    whole = file.read_text()
    file.write_text(whole.replace('"state": "active"', '"state": "inactive"', 1))
    words = [sys.executable, "-m", "urdfctl", "doctor", "--watch", "--seconds", "0.1"]
    environ = {**system, "PYTHONPATH": f"{CHECKOUT}{os.pathsep}{system['PYTHONPATH']}"}
    with subprocess.Popen(words, env=environ, stdout=subprocess.PIPE, text=True, cwd=folder.path) as watched:
        assert watched.stdout is not None
        first = watched.stdout.readline()
        file.write_text(whole)
        rest = watched.stdout.read()
    assert "UC832 controller 'joint_state_broadcaster' is inactive" in first
    assert (watched.returncode, rest.splitlines()[-1][:4]) == (0, "ok: ")


def test_private_values_are_left_out_unless_they_are_asked_for(system: dict[str, str]) -> None:
    values = json.loads(recorded(system).stdout)["parameters"]["/head"]["values"]
    assert (values["robot_serial"], values["rate"], values["joints"]) == ("left out", 2.5, ["pan", "tilt"])
    assert json.loads(recorded(system, "--all").stdout)["parameters"]["/head"]["values"]["robot_serial"] == "A1"


def test_a_system_that_does_not_answer_is_recorded_within_five_seconds_and_nothing_is_left_in_it(
    system: dict[str, str],
) -> None:
    began = time.monotonic()
    found = json.loads(recorded({**system, "FAKE_MUTE": "1"}).stdout)
    assert time.monotonic() - began < LONGEST
    lists = found["controller_managers"]["/controller_manager"]
    assert lists["list_controllers"] == {"error": "service not available"}
    assert found["parameters"]["/head"] == {"error": "service not available"}
    assert Path(f"{system['FAKE_SYSTEM']}.end").read_text() == "destroyed\n"


def test_private_parameters_of_hardware_are_left_out_of_descriptions(system: dict[str, str]) -> None:
    file = Path(system["FAKE_SYSTEM"])
    hardware = '<param name="robot_ip">10.0.0.7</param><param name="rate">5</param></hardware>'
    file.write_text(file.read_text().replace("</hardware>", hardware.replace('"', '\\"')))
    [sent] = json.loads(recorded(system).stdout)["robot_description"]["/robot_description"]
    assert '<param name="robot_ip">left out</param><param name="rate">5</param>' in sent["data"]
    [whole] = json.loads(recorded(system, "--all").stdout)["robot_description"]["/robot_description"]
    assert "10.0.0.7" in whole["data"]


def test_without_a_recording_the_doctor_records_the_system_that_runs_here(
    folder: Folder, system: dict[str, str]
) -> None:
    ran = folder.run("doctor", "--seconds", "0.1", "--snapshot", "now.json", environ=dict(system))
    assert (ran.returncode, ran.stdout[:4]) == (0, "ok: "), ran.stderr
    assert json.loads((folder.path / "now.json").read_text())["recorded"]["distro"] == "jazzy"


def test_without_ros_and_without_a_recording_the_way_out_is_said(folder: Folder) -> None:
    folder.write(FILES)
    ran = folder.run("doctor", environ={"PYTHONPATH": str(CHECKOUT), "ROS_VERSION": None})
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr.startswith("urdfctl: neither ROS 2 nor ROS 1 is sourced for ")
    assert ran.stderr.endswith("source ROS, or name a recording: urdfctl doctor SNAPSHOT.json\n")
