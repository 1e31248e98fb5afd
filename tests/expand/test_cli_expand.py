"""`urdfctl expand` as a command: xacro's bytes, or one clear problem and nothing written."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from folder import Folder
from typer.testing import CliRunner

from urdfctl.commands.app import app

ROBOT = """\
<?xml version="1.0"?>
<!-- a robot -->
<robot name="größe" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <xacro:property name="mass" value="${2 * 0.25}"/>
  <xacro:include filename="part.xacro"/>
  <xacro:part name="$(arg side)"/>
  <link name='tip'><visual/>text &lt;here&gt;</link>
</robot>
"""
PART = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params="name">
    <link name="${name}"><mass value="${mass}"/></link>
  </xacro:macro>
</robot>
"""
BROKEN = PART.replace("${mass}", "${masse}")


def xacro(folder: Folder, *words: str) -> bytes:
    """What xacro itself writes."""
    code = "import sys, xacro; sys.argv[0] = 'xacro'; xacro.main()"
    return subprocess.run([sys.executable, "-c", code, *words], cwd=folder.path, capture_output=True, check=True).stdout


@pytest.mark.parametrize("words", [["robot.xacro"], ["robot.xacro", "side:=right"], ["./robot.xacro", "side:="]])
def test_it_writes_byte_for_byte_what_xacro_writes(folder: Folder, words: list[str]) -> None:
    folder.write({"robot.xacro": ROBOT, "part.xacro": PART})
    ran = folder.run("expand", *words)
    assert (ran.returncode, ran.stderr) == (0, "")
    assert ran.stdout.encode() == xacro(folder, *words)


def test_it_writes_the_same_bytes_to_a_file(folder: Folder) -> None:
    folder.write({"robot.xacro": ROBOT, "part.xacro": PART})
    ran = folder.run("expand", "robot.xacro", "-o", "robot.urdf")
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "")
    assert (folder.path / "robot.urdf").read_bytes() == xacro(folder, "robot.xacro")


def test_it_overwrites_a_file_only_by_force(folder: Folder) -> None:
    folder.write({"robot.xacro": ROBOT, "part.xacro": PART, "robot.urdf": "old"})
    ran = folder.run("expand", "robot.xacro", "-o", "robot.urdf")
    assert (ran.returncode, ran.stderr) == (2, "urdfctl: 'robot.urdf' exists; --force overwrites it\n")
    assert (folder.path / "robot.urdf").read_text() == "old"
    assert folder.run("expand", "robot.xacro", "-o", "robot.urdf", "--force").returncode == 0
    assert (folder.path / "robot.urdf").read_bytes() == xacro(folder, "robot.xacro")


def test_a_device_is_no_file_to_be_overwritten(folder: Folder) -> None:
    folder.write({"robot.xacro": ROBOT, "part.xacro": PART})
    ran = folder.run("expand", "robot.xacro", "-o", "/dev/stdout")
    assert (ran.returncode, ran.stdout.encode()) == (0, xacro(folder, "robot.xacro"))


def test_a_problem_is_told_with_its_place_and_the_way_to_it_and_nothing_is_written(folder: Folder) -> None:
    folder.write({"robot.xacro": ROBOT, "part.xacro": BROKEN})
    ran = folder.run("expand", "robot.xacro", "-o", "robot.urdf")
    assert (ran.returncode, ran.stdout) == (1, "")
    first, *rest = ran.stderr.splitlines()
    assert first.startswith("part.xacro:3:39: error UC006 ")
    assert "'masse'" in first
    assert "  note: in the call of macro 'part' at robot.xacro:7:3" in rest
    assert sorted(os.listdir()) == ["part.xacro", "robot.xacro"]


def test_a_file_that_is_there_outlives_a_problem_whatever_the_force(folder: Folder) -> None:
    folder.write({"robot.xacro": ROBOT, "part.xacro": BROKEN, "robot.urdf": "old"})
    assert folder.run("expand", "robot.xacro", "-o", "robot.urdf", "--force").returncode == 1
    assert (folder.path / "robot.urdf").read_text() == "old"


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["robto.xacro"], "urdfctl: file 'robto.xacro' does not exist; did you mean 'robot.xacro'?\n"),
        (
            ["robot.xacro", "part.xacro"],
            "urdfctl: unexpected argument 'part.xacro': expand reads one file; arguments are name:=value\n",
        ),
        (
            ["robot.xacro", "-o", "nowhere/robot.urdf"],
            "urdfctl: 'nowhere/robot.urdf' cannot be written: No such file or directory\n",
        ),
        (["robot.xacro", "-o", ".", "--force"], "urdfctl: '.' is a folder\n"),
        (["robot.xacro", "--timeout", "0"], "urdfctl: --timeout must be a number of seconds up to 86400, not 0\n"),
    ],
)
def test_a_command_that_cannot_be_meant_has_status_2(folder: Folder, words: list[str], told: str) -> None:
    folder.write({"robot.xacro": ROBOT, "part.xacro": PART})
    ran = folder.run("expand", *words)
    assert (ran.returncode, ran.stdout, ran.stderr) == (2, "", told)


@pytest.mark.parametrize(
    ("text", "code"),
    [("<robot>", "UC001"), ("", "UC001"), ('<!DOCTYPE r [<!ENTITY a "b">]><robot/>', "UC005")],
)
def test_what_cannot_be_read_is_told_with_its_place(folder: Folder, text: str, code: str) -> None:
    folder.write({"robot.xacro": text})
    ran = folder.run("expand", "robot.xacro")
    assert (ran.returncode, ran.stdout) == (1, "")
    assert ran.stderr.startswith("robot.xacro:1:")
    assert f" error {code} " in ran.stderr


def test_an_endless_description_ends_in_time(folder: Folder) -> None:
    endless = '<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>'
    folder.write({"robot.xacro": ROBOT.replace("<xacro:part", endless + "<xacro:part"), "part.xacro": PART})
    ran = folder.run("expand", "robot.xacro")
    assert (ran.returncode, ran.stdout) == (1, "")
    assert "UC014" in ran.stderr


def test_xacros_warnings_go_to_standard_error_and_the_text_is_whole(folder: Folder) -> None:
    twice = PART.replace(
        "</robot>", '<xacro:macro name="part" params="name"><link name="${name}"/></xacro:macro></robot>'
    )
    folder.write({"robot.xacro": ROBOT, "part.xacro": twice})
    ran = folder.run("expand", "robot.xacro")
    assert ran.returncode == 0
    assert ran.stdout.encode() == xacro(folder, "robot.xacro")
    assert "warning UC017" in ran.stderr


def test_only_the_environment_that_is_named_reaches_the_description(folder: Folder) -> None:
    folder.write({"robot.xacro": '<robot name="$(optenv ROBOT none)"><link name="a"/></robot>'})
    assert '<robot name="none">' in folder.run("expand", "robot.xacro", environ={"ROBOT": "left"}).stdout
    named = folder.run("expand", "robot.xacro", "--env", "ROBOT", environ={"ROBOT": "left"}).stdout
    assert '<robot name="left">' in named


def test_help_shows_an_example() -> None:
    shown = CliRunner().invoke(app, ["expand", "--help"], terminal_width=200).output
    assert "Example: urdfctl expand urdf/robot.xacro reach:=0.6 -o robot.urdf" in shown
