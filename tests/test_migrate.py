"""`urdfctl migrate` as a user meets it: what it shows, writes and refuses to write."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from folder import Folder, environment

from urdfctl.cli.migrate_lint import Lint
from urdfctl.cli.writing_all import write_all
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Edit
from urdfctl.fix.edits import Change
from urdfctl.migrate.engine import migrate
from urdfctl.migrate.packages import Packages
from urdfctl.migrate.scratch import Scratch
from urdfctl.migrate.step import Proposal, Step
from urdfctl.migrate.wishes import Part, Wishes
from urdfctl.source.span import SourceSpan

MANIFEST = '<package format="3"><name>arm</name></package>\n'
ROBOT = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="tip"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <!-- the hardware -->
  <ros2_control name="arm"   type="system">
    <hardware><plugin>ign_ros2_control/IgnitionSystem</plugin></hardware>
    <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
MIGRATED = ROBOT.replace("ign_ros2_control/IgnitionSystem", "gz_ros2_control/GazeboSimSystem")
FILES = {"arm/package.xml": MANIFEST, "arm/urdf/arm.urdf.xacro": ROBOT}


def content(folder: Folder, path: str = "arm") -> dict[str, bytes]:
    """The files below a folder, by their names."""
    root = folder.path / path
    return {file.relative_to(root).as_posix(): file.read_bytes() for file in root.rglob("*") if file.is_file()}


def test_without_further_options_migrate_prints_a_diff_that_git_applies_and_writes_nothing(folder: Folder) -> None:
    folder.write(FILES)
    before = content(folder)
    ran = folder.run("migrate", "arm", "--to", "jazzy")
    assert (ran.returncode, content(folder)) == (1, before)
    subprocess.run(["git", "apply"], cwd=folder.path, input=ran.stdout, encoding="utf-8", check=True)
    assert content(folder) == {**before, "urdf/arm.urdf.xacro": MIGRATED.encode()}


def test_in_place_changes_only_the_bytes_that_it_must_and_writes_a_report(folder: Folder) -> None:
    folder.write(FILES)
    ran = folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    assert (ran.returncode, ran.stdout) == (0, "")
    assert (folder.path / "arm/urdf/arm.urdf.xacro").read_text() == MIGRATED
    report = (folder.path / "arm/MIGRATION.md").read_text()
    assert "`urdf/arm.urdf.xacro:10`: 'ign_ros2_control/IgnitionSystem' was renamed" in report


def test_a_migrated_package_is_not_changed_again_and_gets_no_second_report(folder: Folder) -> None:
    folder.write(FILES)
    folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    (folder.path / "arm/MIGRATION.md").unlink()
    once = content(folder)
    ran = folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    assert (ran.returncode, content(folder)) == (0, once)


def test_output_gets_the_whole_package_and_the_report_as_json(folder: Folder) -> None:
    folder.write(FILES)
    before = content(folder)
    folder.run("migrate", "arm", "--to", "jazzy", "-o", "new", "--report", "new.json")
    assert content(folder) == before
    assert content(folder, "new") == {**before, "urdf/arm.urdf.xacro": MIGRATED.encode()}
    [done] = json.loads((folder.path / "new.json").read_text())["done"]
    assert (done["file"], done["line"]) == ("urdf/arm.urdf.xacro", 10)


def test_changes_that_are_not_committed_are_not_overwritten_without_force(folder: Folder) -> None:
    folder.write(FILES)
    subprocess.run(["git", "init", "-q"], cwd=folder.path / "arm", check=True)
    ran = folder.run("migrate", "arm", "--to", "jazzy", "--in-place")
    assert ran.returncode == 2
    assert "not committed" in ran.stderr
    assert content(folder)["urdf/arm.urdf.xacro"] == ROBOT.encode()
    assert folder.run("migrate", "arm", "--to", "jazzy", "--in-place", "--force").returncode == 0


def test_files_that_git_ignores_are_left_alone(folder: Folder) -> None:
    folder.write({**FILES, "arm/.gitignore": "made\n", "arm/made/urdf/arm.urdf": ROBOT})
    subprocess.run(["git", "init", "-q"], cwd=folder.path / "arm", check=True)
    folder.run("migrate", "arm", "--to", "jazzy", "--in-place", "--force")
    after = content(folder)
    assert after["made/urdf/arm.urdf"] == ROBOT.encode()
    assert after["urdf/arm.urdf.xacro"] == MIGRATED.encode()


def test_a_package_of_the_same_name_elsewhere_in_the_workspace_is_not_taken_for_it(folder: Folder) -> None:
    named = {f"{name}/package.xml": MANIFEST.replace("arm", name) for name in ("base", "hand")}
    folder.write({**FILES, **named, "old/package.xml": MANIFEST, ".git/HEAD": ""})
    scratch = Scratch([str(folder.path / "arm")])
    scratch.close()
    assert sorted(Path(other).name for other in scratch.others) == ["base", "hand"]


def test_only_the_parts_that_are_named_are_migrated(folder: Folder) -> None:
    folder.write(FILES)
    assert folder.run("migrate", "arm", "--to", "jazzy", "--only", "yaml,launch").returncode == 0
    assert folder.run("migrate", "arm", "--to", "jazzy", "--only", "urdf").returncode == 1


def test_a_file_that_a_program_changed_meanwhile_stops_the_whole_write(folder: Folder) -> None:
    folder.write({"a": "1", "b": "changed"})
    files = [str(folder.path / name) for name in ("a", "b", "c")]
    changes = [Change(files[0], b"1", b"2"), Change(files[1], b"1", b"2"), Change(files[2], None, b"2")]
    [problem] = write_all(changes)
    assert "was changed by another program" in problem
    assert content(folder, ".") == {"a": b"1", "b": b"changed"}


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals")
@pytest.mark.parametrize("after", [0.2, 0.6, 1.0, 1.4])
def test_a_run_that_is_killed_leaves_all_files_as_they_were_or_as_they_should_be(folder: Folder, after: float) -> None:
    folder.write({**FILES, **{f"arm/urdf/other_{n}.urdf": ROBOT for n in range(6)}})
    before = content(folder)
    command = [sys.executable, "-m", "urdfctl", "migrate", "arm", "--to", "jazzy", "--in-place"]
    running = subprocess.Popen(command, cwd=folder.path, env=environment({}), stderr=subprocess.DEVNULL)
    time.sleep(after)
    running.send_signal(signal.SIGKILL)
    running.wait()
    now = content(folder)
    after_all = {**dict.fromkeys(before, MIGRATED.encode()), "package.xml": MANIFEST.encode()}
    assert {name: now.get(name) for name in before} in (before, after_all)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["arm"], "--to requires the distro"),
        (["arm", "--to", "jazy"], "did you mean 'jazzy'"),
        (["arm", "--to", "noetic"], "--to: unknown distro 'noetic'"),
        (["arm", "--to", "jazzy", "--only", "yml"], "unknown part 'yml'"),
        (["arm", "--to", "jazzy", "--in-place", "-o", "x"], "exclude each other"),
        (["leg", "--to", "jazzy"], "does not exist"),
    ],
)
def test_what_migrate_cannot_do_is_said_in_one_line(folder: Folder, words: list[str], told: str) -> None:
    folder.write(FILES)
    ran = folder.run("migrate", *words)
    assert (ran.returncode, ran.stderr.count("\n")) == (2, 1)
    assert told in ran.stderr


def test_errors_that_only_the_target_has_are_in_the_report(folder: Folder) -> None:
    unknown = ROBOT.replace(
        "</ros2_control>", '<joint name="ghost"><state_interface name="position"/></joint></ros2_control>'
    )
    folder.write({**FILES, "arm/urdf/arm.urdf.xacro": unknown})
    folder.run("migrate", "arm", "--from", "humble", "--to", "jazzy", "--report", "report.json")
    left = json.loads((folder.path / "report.json").read_text())["for_you"]
    assert [entry["message"] for entry in left if "ghost" in entry["message"]]


def test_a_change_that_would_cause_a_finding_of_a_new_kind_is_left_out_and_reported(tmp_path: Path) -> None:
    Folder(tmp_path).write(FILES)

    def breaking(packages: Packages) -> Iterator[Proposal]:
        for path in packages.files(".xacro"):
            source = packages.read(path)
            start = source.data.find(b'"position"')
            if start >= 0:
                yield Proposal(edits=(Edit(SourceSpan(source, start, start + 10), '"positon"'),))

    scratch = Scratch([str(tmp_path / "arm")])
    step = Step("breaking", Part.URDF, "a fault", breaking)
    settings = Settings(workspace=scratch.root)
    result = migrate(scratch, Wishes("jazzy"), settings, Lint(scratch), [step])
    scratch.close()
    assert result.changes == ()
    assert "not changed by step 'breaking'" in result.lines[0].message
