"""`urdfctl smoke --engine ros2`: a stand-in for the real manager answers its services and prints its log."""

from __future__ import annotations

import json
import os
import subprocess
import xml.dom.minidom
from typing import Any

import pytest
from fake_ros import write_fake_ros
from folder import Folder

from urdfctl.rules.running.samples import FILES, sound

MANAGER = "[ros2_control_node-1] [WARN] [1795406020.79] [controller_manager]: "
REFUSED = "Unable to activate controller 'head' since the command interface 'pan/position' is not available."
NO_PLUGIN = (
    "[ERROR] [1.0] [controller_manager]: Caught exception of type : N9pluginlib20LibraryLoadExceptionE while loading "
    "hardware: According to the loaded plugin descriptions the class arm_driver/ArmSystem with base class type "
    "hardware_interface::SystemInterface does not exist. Declared types are  mock_components/GenericSystem"
)
ROS2 = """#!/bin/sh
echo "$@" > "$FAKE_SYSTEM.words"
cat "$FAKE_SYSTEM.log"
[ -n "$FAKE_MUTE" ] || exec sleep 60
"""


def tried(folder: Folder, recording: dict[str, Any], log: str = "", *words: str) -> subprocess.CompletedProcess[str]:
    write_fake_ros(folder.path / "ros")
    folder.write({**FILES, "system.json": json.dumps(recording), "system.json.log": log, "bin/ros2": ROS2})
    (folder.path / "bin/ros2").chmod(0o755)
    environ = {
        "PYTHONPATH": str(folder.path / "ros"),
        "FAKE_SYSTEM": str(folder.path / "system.json"),
        "PATH": f"{folder.path / 'bin'}{os.pathsep}{os.environ['PATH']}",
        "ROS_DISTRO": "jazzy",
    }
    return folder.run("smoke", "launch/arm.launch.xml", "--engine", "ros2", *words, environ=environ)


def test_what_the_real_manager_starts_passes(folder: Folder) -> None:
    ran = tried(folder, sound())
    assert ran.stdout.splitlines()[1:] == [
        "  passed  joint_state_broadcaster: up to activate",
        "  passed  head: up to activate",
    ]
    assert ran.returncode == 0
    words = (folder.path / "system.json.words").read_text()
    assert words.startswith("run controller_manager ros2_control_node --ros-args -r __node:=controller_manager ")
    assert "-p use_sim_time:=false" in words


def test_what_it_refuses_is_explained_by_its_log_and_compared_with_the_simulated_verdict(folder: Folder) -> None:
    ran = tried(folder, {**sound(), "passes": {"head": ["load", "configure"]}}, f"{MANAGER}{REFUSED}\n")
    first, second, third, *_ = ran.stdout.splitlines()[2:]
    assert first == f"  failed  head at activate: {REFUSED}"
    assert second.startswith('          fix: Run "ros2 control list_hardware_interfaces"')
    assert third.startswith("  differs head: the simulated manager starts it; please report")
    assert ran.returncode == 1


def test_a_manager_that_ends_before_it_answers_says_why(folder: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FAKE_MUTE", "1")
    ran = tried(folder, sound(), NO_PLUGIN + "\n", "--format", "json")
    [robot] = json.loads(ran.stdout)["robots"]
    assert "arm_driver/ArmSystem" in robot["reason"]
    assert (robot["controllers"], ran.returncode) == ([], 1)


def test_the_hardware_of_the_description_is_mocked() -> None:
    from urdfctl.doctor.trial import with_mock_hardware
    from urdfctl.source.span import SourceText
    from urdfctl.source.xml.parsing import parse

    hardware = "<hardware><plugin> x/Y </plugin></hardware>"
    text = f'<robot name="a"><ros2_control name="A" type="sensor">{hardware}</ros2_control></robot>'
    root = parse(SourceText("a.urdf", text.encode())).documentElement
    assert root is not None
    mocked = xml.dom.minidom.parseString(with_mock_hardware(root))
    [control], [plugin] = (mocked.getElementsByTagName(name) for name in ("ros2_control", "plugin"))
    assert (control.getAttribute("type"), plugin.firstChild.data) == ("system", "mock_components/GenericSystem")


def test_without_ros_there_is_one_line(folder: Folder) -> None:
    folder.write(FILES)
    ran = folder.run("smoke", "launch/arm.launch.xml", "--engine", "ros2", "--distro", "jazzy")
    assert (ran.returncode, ran.stdout) == (2, "")
    assert "--engine ros2 starts the real controller manager: ROS 2 is not sourced" in ran.stderr
    assert ran.stderr.strip().endswith("source ROS 2, or use --engine none")
