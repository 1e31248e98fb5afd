"""Beginners' slips on the command line get an answer that says what to type."""

from __future__ import annotations

import pytest
from folder import Folder
from typer.testing import CliRunner

from urdfctl.commands.app import app

ARM = (
    '<robot name="arm"><link name="base"/><link name="fore"/><joint name="left_elbow" type="continuous">'
    '<parent link="base"/><child link="fore"/><axis xyz="0 0 1"/></joint></robot>'
)


@pytest.mark.parametrize(
    ("words", "answer"),
    [
        (("arm.urdf",), "'arm.urdf' is not a command; to check it: urdfctl lint arm.urdf"),
        (("gazebo.log",), "'gazebo.log' is not a command; to explain a log: urdfctl explain gazebo.log"),
        (("fix",), "there is no command 'fix'; use: urdfctl lint --fix"),
        (("compare", "a.urdf", "b.urdf"), "there is no command 'compare'; use: urdfctl diff"),
        (
            ("lint", "arm.urdf", "prefix=left_"),
            "file or folder 'prefix=left_' does not exist; to set a xacro argument, write prefix:=left_",
        ),
        (("lint", "arm.urdf", "--distro", "ros1"), "unknown distro 'ros1'; known are "),
        (
            ("lint", "arm.urdf", "--distro", "22.04"),
            "unknown distro '22.04': it is a release of Ubuntu, for which there is humble or iron",
        ),
        (("lint", "arm.urdf", "--distro", "dashing"), "unknown distro 'dashing'; known are "),
        (
            ("gen-controllers", "arm.urdf", "--distro", "jazzy", "--type", "effort", "--joints", "left"),
            "no joint matches 'left': a pattern matches whole names; 'left.*' matches 'left_elbow'",
        ),
        (
            ("gen-controllers", "arm.urdf", "--distro", "jazzy", "--type", "effort", "--joints", "wrist"),
            "no joint matches 'wrist'; the joints are 'left_elbow'",
        ),
        (("lint", "https://example.org/a.urdf"), "is an address; urdfctl reads local files"),
        (("lint", "package://arm/a.urdf"), "is an address of ROS; name the file, e.g. src/arm/a.urdf"),
        (("lint", "$(find arm)/a.urdf"), "contains a substitution of ROS, which a command line does not expand"),
        (("lint", "a.sdf"), "'a.sdf' is an SDF file; name the robot's URDF or xacro"),
        (("smoke", "a.world"), "'a.world' is an SDF file; name the robot's URDF or xacro"),
        (("lint", "a.STL"), "'a.STL' is a mesh; name the robot's URDF or xacro"),
        (("gen-all", "arm.launch"), "'arm.launch' is a launch file; name the robot's URDF or xacro that it starts"),
        (
            ("explain", "arm.urdf"),
            "explain reads rules, messages and logs; to check 'arm.urdf', run: urdfctl lint arm.urdf",
        ),
    ],
    ids=" ".join,
)
def test_a_slip_is_answered_in_one_line_with_exit_status_2(folder: Folder, words: tuple[str, ...], answer: str) -> None:
    files = {"arm.urdf": ARM, "a.sdf": "<sdf/>", "a.world": "<sdf/>", "a.STL": "solid a", "arm.launch": "<launch/>"}
    folder.write({**files, "gazebo.log": ""})
    ran = folder.run(*words)
    assert ran.returncode == 2
    assert answer in ran.stderr.splitlines()[-1]


def test_the_version_has_a_short_option(folder: Folder) -> None:
    assert folder.run("-V").stdout == folder.run("--version").stdout


def test_a_robot_without_any_control_gets_a_hint_how_to_generate_it(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM})
    hint = "nothing controls the robot's joints; to generate control: "
    assert f"{hint}urdfctl gen-all arm.urdf -o arm_control\n" in folder.run("lint", "arm.urdf").stdout
    for_jazzy = folder.run("lint", "arm.urdf", "--distro", "jazzy").stdout
    assert "gen-all arm.urdf --distro jazzy -o arm_control\n" in for_jazzy
    folder.write({"arm/package.xml": "<package><name>arm</name></package>", "arm/urdf/arm.urdf": ARM})
    assert "urdfctl gen-all arm/urdf/arm.urdf -o arm_control\n" in folder.run("lint", "arm").stdout
    folder.write({"arm.urdf": ARM.replace("continuous", "fixed")})
    assert hint not in folder.run("lint", "arm.urdf").stdout


# -- output ----------------------------------------------------------------------------------------------------------


def test_quiet_shows_the_findings_alone(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM.replace('link="base"', 'link="bass"')})
    loud, quiet = folder.run("lint", "arm.urdf").stdout, folder.run("lint", "-q", "arm.urdf").stdout
    assert quiet
    assert loud.startswith(quiet)
    assert loud.removeprefix(quiet).splitlines()[-1].startswith("1 error")


def test_the_report_can_be_written_to_a_file(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM})
    ran = folder.run("lint", "arm.urdf", "--output-file", "report.txt")
    assert (ran.stdout, ran.returncode) == ("", 0)
    assert (folder.path / "report.txt").read_text() == folder.run("lint", "arm.urdf").stdout
    both = folder.run("lint", "arm.urdf", "--format", "text", "--format", "json", "-o", "report.txt")
    assert (both.returncode, "takes one report" in both.stderr) == (2, True)


def test_statistics_are_in_the_concise_report_too(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM})
    ran = folder.run("lint", "arm.urdf", "--format", "concise", "--statistics")
    assert ran.stdout.splitlines()[-1] == "     1  warning UC133 moving-link-without-inertial"


def test_colours_can_be_forced_and_no_color_wins(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM})
    forced = {"FORCE_COLOR": "1", "TERM": "xterm-256color"}
    assert "\x1b[" in folder.run("lint", "arm.urdf", environ=forced).stdout
    assert "\x1b[" not in folder.run("lint", "arm.urdf", environ={**forced, "NO_COLOR": "1"}).stdout


# -- help and completion ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("command", ["lint", "smoke", "show", "expand", "rules", "explain", "gen-all", "gen-check"])
def test_help_names_no_type_of_python(command: str) -> None:
    told = CliRunner().invoke(app, [command, "--help"], terminal_width=100).output
    assert not {"<str>", "<int>", "<float>", "TEXT", "INTEGER", "FLOAT"} & set(told.split())


def test_help_shows_choices_and_groups() -> None:
    told = CliRunner().invoke(app, ["lint", "--help"], terminal_width=100).output
    assert "--simulator [gz|gazebo-classic|mujoco|none]" in told
    assert "--fail-on [error|warning|info]" in told
    headings = [line for line in told.splitlines() if line.endswith(":") and not line.startswith(" ")]
    assert headings[:4] == ["Arguments:", "What it is checked for:", "Rules:", "Fixes:"]


@pytest.mark.parametrize(
    ("typed", "completed"),
    [("urdfctl lint --distro no", "noetic"), ("urdfctl lint --format ju", "junit"), ("urdfctl lin", "lint")],
)
def test_a_shell_completes_commands_and_choices(folder: Folder, typed: str, completed: str) -> None:
    words = {"COMP_WORDS": typed, "COMP_CWORD": str(len(typed.split()) - 1)}
    assert folder.run(environ={"_URDFCTL_COMPLETE": "complete_bash", **words}).stdout.split() == [completed]
