"""`urdfctl lint --fix`, `--unsafe-fixes` and `--diff` as a user meets them."""

from __future__ import annotations

import os
import shutil
import signal
import stat
import subprocess
import sys
import time
from itertools import product
from pathlib import Path

import pytest
from fixable_robots import ARM, HEAD
from folder import Folder, environment
from sampling import sample

FIXED = ARM.replace(">EffortJoint", ">hardware_interface/EffortJoint")
REVERSED = ARM.replace('lower="-1" upper="1"', 'lower="1" upper="-1"')
NOETIC = ("--distro", "noetic")


# -- what is written -------------------------------------------------------------------------------------------------


def test_fix_writes_what_is_surely_meant_and_reports_what_is_left(folder: Folder) -> None:
    folder.write({"arm.urdf": REVERSED})
    ran = folder.run("lint", "arm.urdf", "--fix", *NOETIC)
    assert (folder.path / "arm.urdf").read_text() == REVERSED.replace(">Effort", ">hardware_interface/Effort")
    assert "UC202" not in ran.stdout
    assert "UC125" in ran.stdout
    told = "urdfctl: fixed 1 of 2 findings in 1 file; use --unsafe-fixes to try 1 more\n"
    assert (ran.returncode, ran.stderr) == (0, told)


def test_unsafe_fixes_writes_what_is_most_likely_meant_too(folder: Folder) -> None:
    folder.write({"arm.urdf": REVERSED})
    ran = folder.run("lint", "arm.urdf", "--unsafe-fixes", *NOETIC)
    assert (folder.path / "arm.urdf").read_text() == FIXED
    assert ran.stdout.startswith("no findings in arm.urdf")
    assert (ran.returncode, ran.stderr) == (0, "urdfctl: fixed 2 of 2 findings in 1 file\n")


def test_the_exit_status_is_that_of_what_is_left(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM.replace('type="revolute"', 'type="sideways"')})
    assert folder.run("lint", "arm.urdf", "--fix", *NOETIC).returncode == 1
    folder.write({"arm.urdf": ARM})
    assert folder.run("lint", "arm.urdf", "--fix", "--fail-on", "warning", *NOETIC).returncode == 0


def test_a_robot_without_findings_is_left_as_it_is(folder: Folder) -> None:
    folder.write({"arm.urdf": FIXED})
    before = os.stat("arm.urdf")
    ran = folder.run("lint", "arm.urdf", "--fix", *NOETIC)
    assert ran.stderr == "urdfctl: fixed 0 of 0 findings in 0 files\n"
    assert os.stat("arm.urdf").st_ino == before.st_ino


def test_only_the_rules_that_are_asked_are_fixed(folder: Folder) -> None:
    folder.write({"arm.urdf": REVERSED})
    ran = folder.run("lint", "arm.urdf", "--unsafe-fixes", "--select", "UC1", *NOETIC)
    assert (folder.path / "arm.urdf").read_text() == ARM
    assert ran.stderr == "urdfctl: fixed 1 of 1 finding in 1 file\n"


def test_a_finding_that_is_silenced_is_not_fixed(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM.replace("      <h", "      <!-- urdfctl: ignore[UC202] old --><h")})
    before = (folder.path / "arm.urdf").read_bytes()
    ran = folder.run("lint", "arm.urdf", "--fix", *NOETIC)
    assert ran.stderr == "urdfctl: fixed 0 of 0 findings in 0 files\n"
    assert (folder.path / "arm.urdf").read_bytes() == before


# -- the diff --------------------------------------------------------------------------------------------------------


def test_diff_shows_the_change_writes_nothing_and_exits_with_1(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM})
    ran = folder.run("lint", "arm.urdf", "--diff", *NOETIC)
    assert ran.stdout.splitlines() == [
        "--- a/arm.urdf",
        "+++ b/arm.urdf",
        "@@ -9,7 +9,7 @@",
        '   <transmission name="elbow_trans">',
        "     <type>transmission_interface/SimpleTransmission</type>",
        '     <joint name="elbow">',
        "-      <hardwareInterface>EffortJointInterface</hardwareInterface>",
        "+      <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>",
        "     </joint>",
        '     <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>',
        "   </transmission>",
    ]
    assert (ran.returncode, ran.stderr) == (1, "urdfctl: would fix 1 of 1 finding in 1 file\n")
    assert (folder.path / "arm.urdf").read_text() == ARM


def test_diff_is_empty_and_exits_with_0_where_there_is_nothing_to_fix(folder: Folder) -> None:
    folder.write({"arm.urdf": FIXED.replace('type="revolute"', 'type="sideways"')})
    ran = folder.run("lint", "arm.urdf", "--diff", *NOETIC)
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "urdfctl: would fix 0 of 1 finding in 0 files\n")


def test_diff_shows_what_is_not_sure_only_with_unsafe_fixes(folder: Folder) -> None:
    folder.write({"arm.urdf": REVERSED})
    assert "lower" not in folder.run("lint", "arm.urdf", "--diff", *NOETIC).stdout
    assert (
        '+    <parent link="world"/><child link="tip"/><limit lower="-1"'
        in folder.run("lint", "arm.urdf", "--diff", "--unsafe-fixes", *NOETIC).stdout
    )


def test_a_report_to_a_file_is_written_beside_the_diff(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM})
    ran = folder.run("lint", "arm.urdf", "--diff", "--format", "text", "--format", "json=out.json", *NOETIC)
    assert ran.stdout.startswith("--- a/arm.urdf")
    assert "UC202" in (folder.path / "out.json").read_text()


def test_exit_zero_holds_for_a_diff_too(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM})
    assert folder.run("lint", "arm.urdf", "--diff", "--exit-zero", *NOETIC).returncode == 0


NAMES = ["arm.urdf", "my arm.urdf", "größe/arm 'n' leg.urdf", 'an "arm".urdf']
TEXTS = [ARM, ARM.replace("\n", "\r\n"), "\ufeff" + ARM.rstrip(), ARM.replace("    ", "\t")]


@pytest.mark.skipif(shutil.which("git") is None, reason="git is not here")
@pytest.mark.parametrize(("name", "text"), sample(product(NAMES, TEXTS), 5))
def test_git_makes_of_the_diff_what_fix_would_write(folder: Folder, name: str, text: str) -> None:
    folder.write({name: text, "copy/" + name: text})
    changes = folder.run("lint", name, "--diff", *NOETIC).stdout
    folder.run("lint", "copy/" + name, "--fix", *NOETIC)
    # bytes, for text mode would change the ends of lines
    subprocess.run(["git", "apply", "-"], input=folder_bytes(folder, name), cwd=folder.path, check=True)
    assert changes
    assert (folder.path / name).read_bytes() == (folder.path / "copy" / name).read_bytes() != text.encode()


def folder_bytes(folder: Folder, name: str) -> bytes:
    """The diff as it is printed."""
    command = [sys.executable, "-m", "urdfctl", "lint", name, "--diff", *NOETIC]
    return subprocess.run(command, cwd=folder.path, env=environment({}), capture_output=True, check=False).stdout


# -- which files are written -----------------------------------------------------------------------------------------


def test_the_permissions_of_a_file_are_kept(folder: Folder) -> None:
    folder.write({"arm.urdf": ARM})
    os.chmod("arm.urdf", 0o640)
    folder.run("lint", "arm.urdf", "--fix", *NOETIC)
    assert stat.S_IMODE(os.stat("arm.urdf").st_mode) == 0o640
    assert (folder.path / "arm.urdf").read_text() == FIXED


def test_a_file_that_may_not_be_written_is_told_of_and_the_others_go_on(folder: Folder) -> None:
    folder.write({"a.urdf": ARM, "b.urdf": ARM.replace('"arm"', '"other"')})
    os.chmod("a.urdf", 0o444)
    ran = folder.run("lint", "a.urdf", "b.urdf", "--fix", *NOETIC)
    assert (folder.path / "a.urdf").read_text() == ARM
    assert "hardware_interface/" in (folder.path / "b.urdf").read_text()
    assert ran.stderr.splitlines() == [
        "urdfctl: a.urdf:12:26: UC202 is not fixed: 'a.urdf' is read-only",
        "urdfctl: fixed 1 of 2 findings in 1 file",
    ]


def test_what_xacro_made_is_not_edited(folder: Folder) -> None:
    banner = "<!-- |    This document was autogenerated by xacro from arm.xacro                | -->\n"
    folder.write({"arm.urdf": banner + ARM})
    ran = folder.run("lint", "arm.urdf", "--fix", *NOETIC)
    assert (folder.path / "arm.urdf").read_text() == banner + ARM
    assert ran.stderr.splitlines()[0].endswith(
        "UC202 is not fixed: 'arm.urdf' was generated by xacro. Fix the xacro file instead"
    )


def test_a_link_stays_a_link_and_its_file_is_written_once(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "real/arm.urdf": ARM})
    os.mkdir("robots")
    os.symlink("../real/arm.urdf", "robots/arm.urdf")
    ran = folder.run("lint", "robots/arm.urdf", "real/arm.urdf", "--fix", *NOETIC)
    assert os.path.islink("robots/arm.urdf")
    assert (folder.path / "real/arm.urdf").read_text() == FIXED
    assert ran.stderr.splitlines()[-1].endswith("in 1 file")


def test_nothing_outside_the_workspace_is_written(folder: Folder) -> None:
    folder.write({"mine/.git/HEAD": "", "theirs/arm.urdf": ARM})
    os.symlink("../theirs/arm.urdf", "mine/arm.urdf")
    ran = folder.run("lint", "arm.urdf", "--fix", "--trust", *NOETIC, cwd=folder.path / "mine")
    assert (folder.path / "theirs/arm.urdf").read_text() == ARM
    assert "is outside the workspace" in ran.stderr
    assert ran.stderr.splitlines()[-1] == "urdfctl: fixed 0 of 1 finding in 0 files"


LIBRARY = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="drive" params="joint interface:='Effort'">
    <transmission name="${joint}_trans">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="${joint}"><hardwareInterface>EffortJointInterface</hardwareInterface></joint>
      <actuator name="${joint}_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
  </xacro:macro>
</robot>
"""
CALLS = (
    HEAD.replace("<robot ", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" ')
    + """\
  <xacro:include filename="lib/drive.xacro"/>
  <xacro:drive joint="elbow"/>
</robot>
"""
)


def test_what_stands_in_a_macro_of_an_included_file_is_mended_there(folder: Folder) -> None:
    folder.write({".git/HEAD": "", "arm.xacro": CALLS, "lib/drive.xacro": LIBRARY})
    ran = folder.run("lint", "arm.xacro", "--fix", *NOETIC)
    assert (folder.path / "lib/drive.xacro").read_text() == LIBRARY.replace(">Effort", ">hardware_interface/Effort")
    assert (folder.path / "arm.xacro").read_text() == CALLS
    assert ran.stderr == "urdfctl: fixed 1 of 1 finding in 1 file\n"


@pytest.mark.parametrize("mark", ["", "\ufeff"])
@pytest.mark.parametrize(
    ("old", "new"), [("", ""), ("\n", "\r\n"), ("    ", "\t"), ("<type>", "<!-- größe 🤖 --><type>")]
)
def test_all_other_bytes_of_a_macros_file_stay(folder: Folder, mark: str, old: str, new: str) -> None:
    library = mark + (LIBRARY.replace(old, new) if old else LIBRARY)
    folder.write({".git/HEAD": "", "arm.xacro": mark + CALLS, "lib/drive.xacro": library})
    folder.run("lint", "arm.xacro", "--fix", *NOETIC)
    after = (folder.path / "lib/drive.xacro").read_bytes()
    assert after == library.replace(">Effort", ">hardware_interface/Effort").encode() != library.encode()


JOINTS = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="turning" params="name type">
    <link name="${name}_link">
      <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    </link>
    <joint name="${name}" type="${type}">
      <parent link="world"/><child link="${name}_link"/><limit lower="1" upper="-1" effort="1" velocity="1"/>
    </joint>
  </xacro:macro>
</robot>
"""
ROBOT = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="joints.xacro"/>
  <link name="world"/>
  CALLS
</robot>
"""
REVOLUTE = '<xacro:turning name="elbow" type="revolute"/>'
CONTINUOUS = '<xacro:turning name="wheel" type="continuous"/>'


def test_a_macro_is_not_changed_for_all_its_calls_where_only_some_are_wrong(folder: Folder) -> None:
    robot = ROBOT.replace("CALLS", REVOLUTE + "\n  " + CONTINUOUS)
    folder.write({"joints.xacro": JOINTS, "arm.xacro": robot})
    ran = folder.run("lint", "arm.xacro", "--unsafe-fixes", *NOETIC)
    assert (folder.path / "joints.xacro").read_text() == JOINTS
    why = "the call of macro 'turning' at arm.xacro:5 does not have this finding but would also change"
    told = [f"urdfctl: joints.xacro:7:57: UC125 is not fixed: {why}", "urdfctl: fixed 0 of 1 finding in 0 files"]
    assert ran.stderr.splitlines() == told


def test_what_two_robots_share_is_not_changed_where_only_one_of_them_is_wrong(folder: Folder) -> None:
    one, two = ROBOT.replace("CALLS", REVOLUTE), ROBOT.replace("CALLS", CONTINUOUS)
    folder.write({"joints.xacro": JOINTS, "one.xacro": one, "two.xacro": two})
    ran = folder.run("lint", ".", "--unsafe-fixes", *NOETIC)
    assert (folder.path / "joints.xacro").read_text() == JOINTS
    assert "UC125 is not fixed: the call of macro 'turning' at two.xacro:4 does not have this finding" in ran.stderr


def test_what_two_robots_share_is_mended_once_where_it_is_wrong_in_both(folder: Folder) -> None:
    robot = ROBOT.replace("CALLS", REVOLUTE)
    folder.write({"joints.xacro": JOINTS, "one.xacro": robot, "two.xacro": robot})
    ran = folder.run("lint", ".", "--unsafe-fixes", *NOETIC)
    assert 'lower="-1" upper="1"' in (folder.path / "joints.xacro").read_text()
    assert ran.stderr == "urdfctl: fixed 1 of 1 finding in 1 file\n"


def test_an_edit_that_would_bring_another_finding_is_left_and_the_rest_is_done(folder: Folder) -> None:
    wheel = '<gazebo><plugin name="p" filename="libgazebo_ros_diff_drive.so"><torque></torque></plugin></gazebo>'
    folder.write({"arm.urdf": REVERSED.replace("</robot>", f"  {wheel}\n</robot>")})
    ran = folder.run("lint", "arm.urdf", "--unsafe-fixes", *NOETIC)
    assert "<torque>" in (folder.path / "arm.urdf").read_text()
    assert 'lower="-1" upper="1"' in (folder.path / "arm.urdf").read_text()
    assert "UC511 is not fixed: the fix would cause UC514 (<wheelTorque> of" in ran.stderr


# -- a process that is killed ----------------------------------------------------------------------------------------


def test_killed_at_any_moment_it_leaves_no_file_half_written(folder: Folder) -> None:
    names = [f"arm{number}.urdf" for number in range(6)]
    command = [sys.executable, "-m", "urdfctl", "lint", *names, "--fix", "--jobs", "2", *NOETIC]
    folder.write(dict.fromkeys(names, ARM))
    started = time.monotonic()
    subprocess.run(command, env=environment({}), cwd=folder.path, capture_output=True, check=False)
    took = time.monotonic() - started

    def states() -> set[str]:
        return {(Path(folder.path) / name).read_text() for name in names}

    for part in sample(range(8), 3):
        folder.write(dict.fromkeys(names, ARM))
        process = subprocess.Popen(
            command, env=environment({}), cwd=folder.path, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        deadline = time.monotonic() + took * (0.5 + part / 14)
        while (part == 0 and states() == {ARM} and process.poll() is None) or time.monotonic() < deadline:
            time.sleep(0.001)
        process.send_signal(signal.SIGKILL)
        process.wait()
        assert states() <= {ARM, FIXED}
        assert part > 0 or FIXED in states()
