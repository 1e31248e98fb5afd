"""`urdfctl lint` as a command: its options, its exit status, and its manners as a process."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from folder import Folder, environment
from typer.testing import CliRunner

from urdfctl.commands.app import app
from urdfctl.report import FORMATS

SOUND = """\
<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="mount" type="fixed"><parent link="base"/><child link="tip"/></joint>
</robot>
"""
ERROR = SOUND.replace('type="fixed"', 'type="sideways"')
WARNING = SOUND.replace('<link name="base"/>', '<link name="base"/><!-- urdfctl: ignore[UC201] -->')
ASKS = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="type" default="fixed"/>
  <link name="base"/>
  <link name="tip"/>
  <joint name="mount" type="$(arg type)"><parent link="base"/><child link="tip"/></joint>
</robot>
"""


UNKNOWN_FORMAT = (
    "urdfctl: unknown format 'jsn'; did you mean 'json'?; "
    "known are text, concise, json, jsonl, sarif, github, gitlab, junit\n"
)

# -- exit status -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "words", "status"),
    [
        (SOUND, [], 0),
        (ERROR, [], 1),
        (ERROR, ["--exit-zero"], 0),
        (ERROR, ["--ignore", "UC121"], 0),
        (WARNING, [], 0),
        (WARNING, ["--fail-on", "warning"], 1),
        (WARNING, ["--fail-on", "info"], 1),
        (WARNING, ["--fail-on=warning", "--exit-zero"], 0),
        ("no robot at all", [], 1),
        ("", [], 1),
    ],
)
def test_the_exit_status_tells_what_was_found(folder: Folder, text: str, words: list[str], status: int) -> None:
    folder.write({"arm.urdf": text})
    ran = folder.run("lint", "arm.urdf", *words)
    assert (ran.returncode, ran.stderr) == (status, "")


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["amr.urdf"], "urdfctl: file or folder 'amr.urdf' does not exist; did you mean 'arm.urdf'?\n"),
        (["arm.urdf", "nowhere/x"], "urdfctl: file or folder 'nowhere/x' does not exist\n"),
        (["arm.urdf", "--distro", "jazy"], "urdfctl: unknown distro 'jazy'; did you mean 'jazzy'?\n"),
        (
            ["arm.urdf", "--format", "jsn"],
            UNKNOWN_FORMAT,
        ),
        (["arm.urdf", "--format", "json="], "urdfctl: --format json= requires the name of a file\n"),
        (
            ["arm.urdf", "--format", "json=nowhere/x"],
            "urdfctl: 'nowhere/x' cannot be written: No such file or directory\n",
        ),
        (["arm.urdf", "--fail-on", "fatal"], "urdfctl: --fail-on must be error, warning or info, not 'fatal'\n"),
        (["arm.urdf", "--select", "UC87"], "urdfctl: no rule's code begins with 'UC87'; see urdfctl rules\n"),
        (["arm.urdf", "--workspace", "nowhere"], "urdfctl: folder 'nowhere' does not exist\n"),
        (["arm.urdf", "--workspace", ""], "urdfctl: folder '' does not exist\n"),
        (
            ["arm.urdf", "--jobs=-1"],
            "urdfctl: --jobs must be a number of robots, or 0 for one for each processor; not -1\n",
        ),
        (["arm.urdf", "--timeout", "0"], "urdfctl: --timeout must be a number of seconds up to 86400, not 0\n"),
    ],
)
def test_a_command_that_cannot_be_meant_is_told_in_one_line_with_status_2(
    folder: Folder, words: list[str], told: str
) -> None:
    folder.write({"arm.urdf": SOUND})
    ran = folder.run("lint", *words)
    assert (ran.returncode, ran.stdout, ran.stderr) == (2, "", told)


@pytest.mark.parametrize("words", [["--distr", "noetic"], ["--timeout", "soon"], ["--jobs"], ["--trust=yes"], ["-x"]])
def test_an_option_that_is_not_known_or_lacks_its_value_has_status_2(folder: Folder, words: list[str]) -> None:
    folder.write({"arm.urdf": SOUND})
    ran = folder.run("lint", "arm.urdf", *words)
    assert ran.returncode == 2
    assert ran.stderr.splitlines()[-1].startswith("Error: ")
    assert "Traceback" not in ran.stderr


def test_a_robot_over_its_memory_is_a_finding_and_no_crash(folder: Folder) -> None:
    folder.write({"arm.urdf": SOUND})
    ran = folder.run("lint", "arm.urdf", "--memory", "1")
    assert ran.returncode == 1
    assert "UC014" in ran.stdout


def test_a_fault_of_ours_has_status_3_whatever_else_is_asked(folder: Folder) -> None:
    folder.write(
        {
            "arm.urdf": SOUND,
            "crash.py": """
import sys
import urdfctl.lint.target, urdfctl.rules
from urdfctl.diagnostic import Finding, Severity
from urdfctl.rule import Rule, rule

@rule("UC998", severity=Severity.WARNING, runtime="ignores", authority="", bad=[], good=[])
def made_to_crash(project):
    "It crashes."
    yield Finding(project.robot.at, "found before")
    raise ZeroDivisionError("of all things")

from functools import partial
rules = (*(fault for fault in urdfctl.rules.all_faults() if isinstance(fault, Rule)), made_to_crash)
urdfctl.lint.target.lint = partial(urdfctl.lint.target.lint, rules=rules)
from urdfctl.__main__ import main
sys.argv[1:] = ["lint", "arm.urdf", "--exit-zero", "--jobs", "1"]
main()
""",
        }
    )
    ran = subprocess.run([sys.executable, "crash.py"], capture_output=True, text=True, check=False)
    assert ran.returncode == 3
    assert "error UC000 rule UC998 made-to-crash crashed: ZeroDivisionError: of all things" in ran.stdout
    assert "warning UC998 found before" in ran.stdout
    assert "please report it" in ran.stdout


def test_a_crash_outside_of_workers_is_told_with_a_report_to_paste(folder: Folder) -> None:
    folder.write(
        {
            "crash.py": """
import sys
from urdfctl.lint import run
def broken(*_): raise ZeroDivisionError("of all things")
run.find = broken
from urdfctl.__main__ import main
sys.argv[1:] = ["lint", "arm.urdf"]
main()
""",
        }
    )
    ran = subprocess.run([sys.executable, "crash.py"], capture_output=True, text=True, check=False)
    assert ran.returncode == 3
    assert "this is a bug in urdfctl, not an error in your robot" in ran.stderr
    assert "command: crash.py lint arm.urdf" in ran.stderr
    assert "ZeroDivisionError: of all things" in ran.stderr


# -- what is linted --------------------------------------------------------------------------------------------------


def test_arguments_reach_the_robot(folder: Folder) -> None:
    folder.write({"arm.xacro": ASKS})
    assert folder.run("lint", "arm.xacro").returncode == 0
    ran = folder.run("lint", "arm.xacro", "type:=sideways", "--ignore", "UC02")
    assert ran.returncode == 1
    assert "'sideways'" in ran.stdout


def test_an_argument_without_a_value_is_left_out_as_xacro_does(folder: Folder) -> None:
    folder.write({"arm.xacro": ASKS})
    assert folder.run("lint", "arm.xacro", "type:=").returncode == 0


def test_several_robots_are_told_in_one_report(folder: Folder) -> None:
    folder.write({"one.urdf": ERROR, "two.urdf": SOUND, "three.urdf": ERROR})
    ran = folder.run("lint", "two.urdf", "one.urdf", "three.urdf", "--format", "concise", "--select", "UC121")
    assert [line.split(": ")[0] for line in ran.stdout.splitlines()] == ["one.urdf:4:29", "three.urdf:4:29"]
    whole = json.loads(folder.run("lint", "two.urdf", "one.urdf", "--format", "json").stdout)
    assert [target["robot"] for target in whole["targets"]] == ["two.urdf", "one.urdf"]


def test_the_order_is_the_same_with_one_job_and_with_many(folder: Folder) -> None:
    names = [f"robot_{number}.urdf" for number in range(12)]
    folder.write(dict.fromkeys(names, ERROR))
    one = folder.run("lint", *names, "--jobs", "1")
    assert folder.run("lint", *names, "--jobs", "8").stdout == one.stdout
    assert one.stdout.count("UC121") == 12


def test_a_folder_means_its_robots(folder: Folder) -> None:
    folder.write({"urdf/one.urdf": ERROR, "urdf/deep/two.urdf": SOUND, "urdf/lone_link.urdf": '<robot name="l"/>'})
    whole = json.loads(folder.run("lint", "urdf", "--format", "json").stdout)
    assert [target["robot"] for target in whole["targets"]] == ["urdf/deep/two.urdf", "urdf/one.urdf"]


def test_no_path_means_the_package_around_the_current_folder(folder: Folder) -> None:
    folder.write({"package.xml": "<package><name>arm</name></package>", "urdf/arm.urdf": ERROR, "config/x": ""})
    ran = folder.run("lint", cwd=folder.path / "config")
    assert ran.returncode == 1
    assert f"{folder.path}/urdf/arm.urdf:4:29: error UC121" in ran.stdout


def test_a_controllers_file_alone_is_accepted_and_nothing_is_found_in_it_yet(folder: Folder) -> None:
    folder.write({"controllers.yaml": "controller_manager:\n"})
    ran = folder.run("lint", "controllers.yaml")
    assert (ran.returncode, ran.stderr) == (0, "")


def test_a_folder_without_a_robot_is_told(folder: Folder) -> None:
    folder.write({"empty/readme.txt": ""})
    ran = folder.run("lint", "empty")
    assert ran.returncode == 2
    assert ran.stderr == (
        "urdfctl: nothing to lint in empty: name a robot (.urdf, .xacro), a controller file (.yaml) or a launch file, "
        "or a folder that contains one\n"
    )


def test_launch_files_that_start_no_robot_of_the_workspace_are_not_green(folder: Folder) -> None:
    spawned = '<node pkg="ros_gz_sim" exec="create" args="-topic robot_description"/>'
    folder.write({"launch/spawn.launch.xml": f"<launch>{spawned}</launch>"})
    assert "nothing here publishes" in folder.run("lint", "launch").stdout
    included = '<include file="$(find-pkg-share foreign)/launch/rsp.launch.py"/>'
    folder.write({"launch/spawn.launch.xml": f"<launch>{included}{spawned}</launch>"})
    ran = folder.run("lint", "launch")
    assert ran.returncode == 2
    assert ran.stderr == (
        "urdfctl: nothing to lint in launch: it contains launch files, but they start no robot or controllers of this "
        "workspace\n"
    )


def test_controllers_in_a_section_with_an_empty_name_are_read(folder: Folder) -> None:
    folder.write({"ros_control.yaml": '"":\n  arm:\n    type: effort_controllers/JointPositionController\n'})
    ran = folder.run("lint", "ros_control.yaml")
    assert ran.returncode == 1
    assert "2:3: error UC431" in ran.stdout


def test_paths_may_hold_blanks_and_any_letters(folder: Folder) -> None:
    name = "mein Ordner/größter 腕 'x'.urdf"
    folder.write({name: ERROR})
    ran = folder.run("lint", name)
    assert ran.returncode == 1
    assert f"\n{name}:4:29: error UC121" in f"\n{ran.stdout}"


@pytest.mark.parametrize(
    "name", ["nothing", "folder.xacro", "device.xacro", "link.xacro", "binary.urdf", "utf16.urdf", "secret.urdf"]
)
def test_what_cannot_be_read_is_one_finding(folder: Folder, name: str) -> None:
    folder.write({"nothing": b"", "binary.urdf": bytes(range(256)) * 40, "utf16.urdf": SOUND.encode("utf-16")})
    folder.write({"secret.urdf": SOUND})
    os.symlink("/dev/zero", "device.xacro")
    os.symlink("nowhere", "link.xacro")
    os.mkdir("folder.xacro")
    if name == "secret.urdf":
        os.chmod(name, 0)
        if os.access(name, os.R_OK):
            pytest.skip("this user may read everything")
    ran = folder.run("lint", name, "--workspace", "/")
    assert ran.returncode == (2 if name == "folder.xacro" else 1), ran.stdout + ran.stderr
    assert ran.stdout.count(" error UC0") == (0 if name == "folder.xacro" else 1), ran.stdout
    assert "Traceback" not in ran.stdout + ran.stderr


# -- formats ---------------------------------------------------------------------------------------------------------


def test_several_formats_go_where_each_is_sent(folder: Folder) -> None:
    folder.write({"arm.urdf": ERROR})
    ran = folder.run("lint", "arm.urdf", "--format", "json=report.json", "--format", "text", "--format=concise=c.txt")
    assert ran.stdout == folder.run("lint", "arm.urdf").stdout
    assert json.loads((folder.path / "report.json").read_text())["summary"]["error"] == 1
    assert (folder.path / "c.txt").read_text().count("\n") == ran.stdout.count(" UC")


def test_each_format_says_the_same_on_standard_output_and_in_a_file(folder: Folder) -> None:
    folder.write({"arm.urdf": ERROR})
    both = [word for name in FORMATS for word in ("--format", f"{name}=report.{name}")]
    ran = folder.run("lint", "arm.urdf", *both)
    assert (ran.returncode, ran.stdout, ran.stderr) == (1, "", "")
    for name in FORMATS:
        written = (folder.path / f"report.{name}").read_text()
        assert "mount" in written, name
        assert folder.run("lint", "arm.urdf", "--format", name).stdout == written, name


LISTS_MODULES = """
import sys
from urdfctl.commands.running import run_words
run_words(["lint", "arm.urdf", "--format", "github"])
print(*sys.modules, file=sys.stderr)
"""


def test_formats_that_are_not_asked_for_are_not_loaded(folder: Folder) -> None:
    folder.write({"arm.urdf": ERROR})
    ran = subprocess.run([sys.executable, "-c", LISTS_MODULES], capture_output=True, text=True, check=True)
    loaded = set(ran.stderr.split())
    reports = {name for name in loaded if name.startswith("urdfctl.report.")}
    assert reports == {
        "urdfctl.report.common",
        "urdfctl.report.fingerprint",
        "urdfctl.report.github",
        "urdfctl.report.words",
    }
    assert not loaded & {"rich", "typer", "xml.sax.saxutils"}


def test_what_reads_launch_files_is_not_loaded_where_there_are_none(folder: Folder) -> None:
    folder.write({"arm.urdf": ERROR})
    ran = subprocess.run([sys.executable, "-c", LISTS_MODULES], capture_output=True, text=True, check=True)
    assert [name for name in ran.stderr.split() if "launch" in name or "moveit" in name] == [
        "urdfctl.discover.launch_files"
    ]


def test_a_report_overwrites_the_one_before(folder: Folder) -> None:
    folder.write({"arm.urdf": ERROR, "report.json": "old"})
    folder.run("lint", "arm.urdf", "--format", "json=report.json")
    assert json.loads((folder.path / "report.json").read_text())["version"] == 1


# -- manners ---------------------------------------------------------------------------------------------------------


def test_a_reader_that_goes_away_hears_no_complaint(folder: Folder) -> None:
    folder.write({"arm.urdf": ERROR.replace("</robot>", '<joint name="x" type="y"/>' * 3000 + "</robot>")})
    command = f"{sys.executable} -m urdfctl lint arm.urdf | head -n 1"
    ran = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)
    assert ran.stdout.count("\n") == 1
    assert ran.stderr == ""


def test_a_closed_output_is_no_crash(folder: Folder) -> None:
    folder.write({"arm.urdf": ERROR})
    command = f"{sys.executable} -m urdfctl lint arm.urdf >&-"
    ran = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stderr) == (1, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
def test_a_full_disk_is_no_crash(folder: Folder) -> None:
    folder.write({"arm.urdf": ERROR})
    command = f"{sys.executable} -m urdfctl lint arm.urdf >/dev/full"
    ran = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stderr) == (
        2,
        "urdfctl: standard output cannot be written: No space left on device\n",
    )


SLOW = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="m" params="n">
    <xacro:if value="${n > 0}"><xacro:m n="${n - 1}"/><xacro:m n="${n - 1}"/></xacro:if>
  </xacro:macro>
  <xacro:m n="13"/>
</robot>
"""


@pytest.mark.skipif(shutil.which("ps") is None, reason="needs ps, to see the workers")
def test_an_interrupt_ends_it_quietly_and_its_workers_too(folder: Folder) -> None:
    process = slow(folder, signal.SIG_DFL)
    until(lambda: len(members(process.pid)) == 2)
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert (process.returncode, out, err) == (130, "", "")
    until(lambda: not members(process.pid))


@pytest.mark.skipif(shutil.which("ps") is None, reason="needs ps, to see the workers")
def test_where_interrupts_are_ignored_as_in_the_background_of_a_shell_the_workers_ignore_them_too(
    folder: Folder,
) -> None:
    process = slow(folder, signal.SIG_IGN)
    until(lambda: len(members(process.pid)) == 2)
    os.killpg(process.pid, signal.SIGINT)
    out, _ = process.communicate(timeout=60)
    assert process.returncode != 3
    assert "gave no result" not in out


def slow(folder: Folder, interrupted: signal.Handlers) -> subprocess.Popen[str]:
    """A run that takes long, in a group of its own."""
    folder.write({"slow.xacro": SLOW})
    return subprocess.Popen(
        [sys.executable, "-m", "urdfctl", "lint", "slow.xacro"],
        cwd=folder.path,
        env=environment({}),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, interrupted),  # noqa: PLW1509 (there are none here)
    )


def members(group: int) -> list[str]:
    """The processes of a group that have not ended."""
    listed = subprocess.run(["ps", "-A", "-o", "pgid=,stat=,pid="], capture_output=True, text=True, check=True).stdout
    rows = [line.split() for line in listed.splitlines()]
    return [pid for pgid, state, pid in rows if int(pgid) == group and not state.startswith("Z")]


def until(holds: Callable[[], bool]) -> None:
    """Wait until something holds, however busy the machine is; what never holds fails after 3000 looks."""
    for _ in range(3000):
        if holds():
            return
        time.sleep(0.02)
    pytest.fail("it never came to hold")


@pytest.mark.parametrize(
    "environ",
    [
        {"HOME": None},
        {"LANG": "C", "LC_ALL": "C"},
        {"LANG": None, "LC_ALL": "POSIX", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
        {"PYTHONIOENCODING": "ascii"},
        {"COLUMNS": "20"},
    ],
)
def test_the_report_is_the_same_whatever_the_environment(folder: Folder, environ: dict[str, str | None]) -> None:
    folder.write({"größe.urdf": ERROR.replace("mount", "größe 腕")})
    ran = folder.run("lint", "größe.urdf", environ=environ)
    assert (ran.stdout, ran.stderr) == (folder.run("lint", "größe.urdf").stdout, "")
    assert "größe 腕" in ran.stdout


def test_a_sourced_ros_with_a_xacro_of_its_own_does_not_matter(folder: Folder) -> None:
    folder.write(
        {
            "arm.xacro": ASKS,
            "ros/xacro/__init__.py": "raise SystemExit('the xacro of ROS')",
            "ros/xacro/xmlutils.py": "",
        }
    )
    ran = folder.run("lint", "arm.xacro", environ={"PYTHONPATH": str(folder.path / "ros")})
    assert (ran.returncode, ran.stderr) == (0, "")


def test_help_shows_an_example_and_every_option() -> None:
    shown = CliRunner().invoke(app, ["lint", "--help"], terminal_width=200).output
    assert "Example: urdfctl lint urdf/robot.xacro reach:=0.6 --distro jazzy" in shown
    for option in ("--distro", "--simulator", "--start", "--workspace", "--package-path", "--env", "--trust"):
        assert option in shown
