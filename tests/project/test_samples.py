"""The sound samples: lint finds nothing in them, and what controls them is what the generators write."""

from __future__ import annotations

import json
import re
import shlex
import shutil
from pathlib import Path

import pytest
from folder import CHECKOUT, Folder
from generating import command

SAMPLES = {"mybot": "noetic", "my_robot": "noetic", "radu": "humble"}


def generated(sample: str) -> dict[str, list[str]]:
    """The command that made each generated file of a sample, by the file's name in it."""
    root, found = CHECKOUT / "samples" / sample, {}
    for path in sorted(root.rglob("*.*")):
        said = re.search(r"made by urdfctl (.*?)( -->)?\n", path.read_text(encoding="utf-8"))
        if said:
            found[path.relative_to(root).as_posix()] = shlex.split(said[1])
    return found


@pytest.mark.parametrize("sample", SAMPLES)
def test_what_controls_a_sample_is_generated(sample: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(CHECKOUT / "samples" / sample)
    made = generated(sample)
    assert [words[0] for words in made.values()] in (
        ["gen-controllers", "gen-launch", "gen-gazebo", "gen-transmissions"],
        ["gen-controllers", "gen-launch", "gen-gazebo", "gen-ros2-control"],
    )
    for name, words in made.items():
        assert command(*words, "-o", name, "--check") == (0, "", ""), name


ONE_COMMAND = {
    "mybot": "urdf/mybot.xacro --type velocity --interface effort --namespace mybot --simulator gazebo-classic",
    "my_robot": "urdf/my_robot.xacro --type position --interface effort --namespace MYROBOT --simulator gazebo-classic",
    "radu": "urdf/radu.urdf.xacro --type velocity --simulator gazebo-classic",
}
_INCLUDE = r'.*<xacro:include filename="[^"]*/(transmissions|gazebo|ros2_control).xacro"/>\n'


@pytest.mark.parametrize(("sample", "words"), ONE_COMMAND.items())
def test_a_sample_without_control_gets_it_in_one_command(sample: str, words: str, folder: Folder) -> None:
    shutil.copytree(CHECKOUT / "samples" / sample, folder.path, dirs_exist_ok=True)
    for name in generated(sample):
        (folder.path / name).unlink()
    robot = folder.path / words.split(maxsplit=1)[0]
    robot.write_text(re.sub(_INCLUDE, "", robot.read_text(encoding="utf-8")), encoding="utf-8")
    own = {name: (folder.path / name).read_bytes() for name in ("package.xml", "CMakeLists.txt")}
    ran = command("gen-all", *words.split(), "--distro", SAMPLES[sample], "-o", ".")
    assert ran.returncode == 0, ran.stderr
    assert "add to package.xml" not in ran.stderr
    assert own == {name: (folder.path / name).read_bytes() for name in own}
    for check in (("lint", "--fail-on", "warning"), ("smoke", "--engine", "none"), ("gen-check",)):
        ran = command(*check)
        assert ran.returncode == 0, ran.stdout


def test_what_a_package_lacks_is_said_and_its_own_files_are_kept(folder: Folder) -> None:
    shutil.copytree(CHECKOUT / "samples/my_robot", folder.path, dirs_exist_ok=True)
    build = "cmake_minimum_required(VERSION 3.0.2)\nproject(my_robot)\ninstall(DIRECTORY urdf/ launch DESTINATION x)\n"
    manifest = (folder.path / "package.xml").read_text().replace("<exec_depend>xacro</exec_depend>", "")
    folder.write({"CMakeLists.txt": build, "package.xml": manifest})
    for name in ("config/controllers.yaml", "launch/control.launch"):
        (folder.path / name).unlink()
    ran = command("gen-all", "urdf/my_robot.xacro", "--type", "trajectory", "--distro", "noetic", "-o", ".")
    assert ran.returncode == 0, ran.stderr
    assert (
        "add to package.xml: <exec_depend>joint_trajectory_controller</exec_depend> <exec_depend>xacro</exec_depend>\n"
        in ran.stderr
    )
    assert "next: install in CMakeLists.txt: config\n" in ran.stderr
    assert (folder.path / "CMakeLists.txt").read_text() == build
    assert (folder.path / "package.xml").read_text() == manifest


@pytest.mark.parametrize(("sample", "distro"), SAMPLES.items())
def test_a_sound_sample_has_neither_errors_nor_warnings(
    sample: str, distro: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(CHECKOUT)
    ran = command("lint", str(Path("samples", sample)), "--distro", distro, "--fail-on", "warning")
    assert ran.returncode == 0, ran.stdout


@pytest.mark.parametrize("distro", ["jazzy", "kilted", "lyrical", "rolling"])
def test_the_gripper_migrates_to_later_distros_with_nothing_left_to_do(distro: str, tmp_path: Path) -> None:
    report, migrated = tmp_path / "report.json", tmp_path / "gripper"
    words = ("--from", "humble", "--to", distro, "-o", str(migrated), "--report", str(report))
    assert command("migrate", str(CHECKOUT / "samples/gripper"), *words).returncode == 0
    assert json.loads(report.read_text(encoding="utf-8"))["for_you"] == []
    ran = command("lint", str(migrated), "--distro", distro, "--ignore", "UC704", "--fail-on", "warning")
    assert ran.returncode == 0, ran.stdout
