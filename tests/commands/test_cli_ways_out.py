"""Refusals and hints name the way out: what was meant, and the command that does it."""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest
from doc_lines import copied_samples
from generating import command


@pytest.fixture
def picker(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Work in a copy of the sample."""
    with copied_samples() as root:
        monkeypatch.chdir(root / "samples/picker")
        yield


@pytest.mark.usefixtures("picker")
def test_a_launch_argument_that_nobody_declares_has_a_hint() -> None:
    ran = command("lint", "launch/bringup.launch.py", "reachh:=0.4", "--format", "concise")
    assert "the launch file does not declare it; did you mean 'reach'?" in ran.stdout
    for sound in ("reach:=0.4", "worldly_wisdom:=1"):
        assert "UC021" not in command("lint", "launch/bringup.launch.py", sound, "--format", "concise").stdout


@pytest.mark.usefixtures("picker")
def test_a_topic_is_meant_by_its_last_part() -> None:
    ran = command("graph", "launch/bringup.launch.py", "--focus", "cmd_vl")
    assert ran.stderr == "urdfctl: 'cmd_vl' is not in the graph; did you mean '/base_controller/cmd_vel'?\n"
    assert command("graph", "launch/bringup.launch.py", "--focus", "zzz").stderr.endswith("is not in the graph\n")


@pytest.mark.usefixtures("picker")
def test_several_interfaces_are_named_for_the_controller_that_takes_them() -> None:
    words = ("gen-controllers", "urdf/body.xacro", "--distro", "jazzy")
    refused = command(*words, "--interface", "position,velocity")
    assert refused.returncode == 2
    way = refused.stderr.partition("name them where they fit: ")[2]
    assert "'arm_controller=trajectory[position,velocity]:turn,shoulder,elbow,wrist'" in way
    followed = command(*words, *shlex.split(way))
    assert (followed.returncode, "command_interfaces: [position, velocity]" in followed.stdout) == (0, True)


@pytest.mark.usefixtures("picker")
def test_generators_detect_the_distro_that_lint_detects() -> None:
    ran = command("gen-controllers", "urdf/robot.xacro", "--type", "trajectory", "--joints", "elbow")
    assert (ran.stderr, "--distro jazzy" in ran.stdout.splitlines()[0]) == ("", True)


@pytest.mark.usefixtures("picker")
def test_a_robot_that_has_its_hardware_is_not_given_another_one_without_a_word() -> None:
    ran = command("gen-all", "urdf/robot.xacro", "--distro", "jazzy", "-o", "made")
    assert (ran.returncode, Path("made").exists()) == (1, False)
    assert "it has a <ros2_control> already. Name a file of the robot without it" in ran.stderr
    assert command("gen-all", "urdf/body.xacro", "--distro", "jazzy", "-o", "made").returncode == 0


@pytest.mark.usefixtures("picker")
def test_another_distro_than_that_of_the_configuration_is_told() -> None:
    Path("urdfctl.toml").write_text('distro = "humble"\n')
    told = "urdfctl: --distro jazzy is used, although urdfctl.toml says 'humble'\n"
    for words in (("lint", "."), ("check", ".", "--engine", "none"), ("gen-gazebo", "--simulator", "gz")):
        assert command(*words, "--distro", "jazzy").stderr.startswith(told), words
    assert told not in command("lint", ".", "--distro", "humble").stderr
