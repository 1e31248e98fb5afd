"""What the user names on the command line, or in the environment, is read wherever it is; and what a project names is
refused in one line that says what to do."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping

import pytest
from folder import Folder

needs_links = pytest.mark.skipif(os.name != "posix", reason="links are made as POSIX makes them")
MANIFEST = "<package format='3'><name>{}</name><export><build_type>ament_cmake</build_type></export></package>\n"
JOINT = (
    '<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>'
    '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
)
ROBOT = f'<robot name="r"><link name="a"/><link name="b"/>{JOINT}</robot>\n'
OTHER = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="{}"/></robot>\n'
PART = f'<robot><link name="a"/><link name="b"/>{JOINT}</robot>\n'
PROJECT = {
    "pull/.git/HEAD": "",
    "pull/r.xacro": OTHER.format("$(find parts)/part.xacro"),
    "opt/parts/package.xml": MANIFEST.format("parts"),
    "opt/parts/part.xacro": PART,
}


def read(folder: Folder, *words: str, environ: Mapping[str, str | None] | None = None) -> set[str]:
    """The robots that a lint of the project can read whole, by the names of their files."""
    ran = folder.run("lint", "--format", "json", *words, cwd=folder.path / "pull", environ=environ)
    assert ran.returncode in {0, 1}, ran.stderr
    targets = json.loads(ran.stdout)["targets"]
    return {os.path.basename(target["robot"]) for target in targets if target["complete"]}


def refused(folder: Folder, *words: str) -> str:
    ran = folder.run(*words, cwd=folder.path / "pull")
    assert (ran.returncode, ran.stdout, ran.stderr.count("\n")) == (2, "", 1), ran.stdout
    return ran.stderr.removeprefix("urdfctl: ").rstrip()


# -- what the user names -----------------------------------------------------------------------------------------------


def test_options_and_the_environment_name_what_is_outside(folder: Folder) -> None:
    folder.write(
        {**PROJECT, "pre/share/parts/package.xml": MANIFEST.format("parts"), "pre/share/parts/part.xacro": PART}
    )
    opt, prefix = str(folder.path / "opt"), str(folder.path / "pre")
    assert read(folder, ".") == set()
    assert read(folder, ".", "--package-path", "../opt") == {"r.xacro"}
    assert read(folder, ".", "--workspace", "..") == {"r.xacro"}
    assert read(folder, ".", environ={"URDFCTL_PACKAGE_PATHS": opt}) == {"r.xacro"}
    assert read(folder, ".", environ={"ROS_PACKAGE_PATH": opt}) == {"r.xacro"}
    assert read(folder, ".", environ={"AMENT_PREFIX_PATH": prefix}) == {"r.xacro"}


def test_a_file_by_its_path_needs_trust_or_a_wider_workspace(folder: Folder) -> None:
    folder.write({**PROJECT, "pull/r.xacro": OTHER.format(folder.path / "opt/parts/part.xacro")})
    assert read(folder, ".") == set()
    assert read(folder, ".", "--trust") == {"r.xacro"}
    assert read(folder, ".", "--workspace", "..") == {"r.xacro"}
    assert read(folder, ".", "--package-path", "../opt") == {"r.xacro"}


def test_a_configuration_outside_of_the_project_is_the_users(folder: Folder) -> None:
    folder.write(
        {**PROJECT, "ci/urdfctl.toml": 'package-paths = ["../opt"]\n[[robot]]\npath = "../opt/parts/part.xacro"\n'}
    )
    assert read(folder, ".", "--config", "../ci/urdfctl.toml") == {"r.xacro"}
    assert read(folder, "--config", "../ci/urdfctl.toml") == {"part.xacro", "r.xacro"}


@needs_links
def test_links_within_a_workspace_and_links_of_the_user_are_followed(folder: Folder) -> None:
    folder.write({"pull/.git/HEAD": "", "pull/parts/part.xacro": PART, "pull/x/none": "", "mine/robot.urdf": ROBOT})
    (folder.path / "pull/x/l.xacro").symlink_to("../parts/part.xacro")
    (folder.path / "pull/r.xacro").write_text(OTHER.format("x/l.xacro"))
    (folder.path / "mine.urdf").symlink_to("mine/robot.urdf")
    (folder.path / "my folder").symlink_to("mine")
    assert read(folder, "r.xacro") == {"r.xacro"}
    assert read(folder, "x/l.xacro") == {"l.xacro"}
    assert read(folder, "../mine.urdf") == {"mine.urdf"}
    assert read(folder, "../my folder") == {"robot.urdf"}


def test_files_that_options_name_are_read_wherever_they_are(folder: Folder) -> None:
    controllers = "controller_manager: {ros__parameters: {update_rate: 100}}\n"
    folder.write({"pull/.git/HEAD": "", "pull/r.urdf": ROBOT, "etc/c.yaml": controllers, "etc/j.csv": "j\n"})
    for words in (
        ["lint", "r.urdf", "../etc/c.yaml"],
        ["smoke", "r.urdf", "--controllers", "../etc/c.yaml", "--engine", "none", "--allow-empty"],
        ["lint", "r.urdf", "--write-baseline", "../etc/b.json"],
        ["lint", "r.urdf", "--baseline", "../etc/b.json"],
        ["gen-controllers", "../etc/j.csv", "--type", "effort", "--distro", "jazzy", "-o", "../etc/made.yaml"],
        ["gen-check", "../etc/made.yaml"],
        ["schema", "--check", "../etc/c.yaml", "--distro", "jazzy"],
    ):
        ran = folder.run(*words, cwd=folder.path / "pull")
        assert ran.returncode == 0, (words, ran.stdout, ran.stderr)


def test_a_generated_file_may_name_what_is_elsewhere_in_its_workspace(folder: Folder) -> None:
    folder.write({"pull/.git/HEAD": "", "pull/description/r.urdf": ROBOT, "pull/control/x": ""})
    words = ("gen-controllers", "../description/r.urdf", "--type", "effort", "--distro", "jazzy", "-o", "made.yaml")
    assert folder.run(*words, cwd=folder.path / "pull/control").returncode == 0
    for place in ("pull", "pull/control", "."):
        ran = folder.run("gen-check", str(folder.path / "pull"), cwd=folder.path / place)
        assert (ran.returncode, ran.stderr) == (0, "")


# -- what a project names ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", ["/etc", "../home", "sub/../../home"])
def test_a_folder_with_packages_outside_is_refused_with_the_way_out(folder: Folder, path: str) -> None:
    folder.write(
        {"pull/.git/HEAD": "", "pull/urdfctl.toml": f'package-paths = ["{path}"]\n', "home/x": "", "pull/sub/x": ""}
    )
    assert refused(folder, "lint", ".") == (
        f"urdfctl.toml: package-paths: folder '{path}' is outside the workspace; name it with --package-path, or in "
        "URDFCTL_PACKAGE_PATHS"
    )


@pytest.mark.parametrize(
    ("key", "text"),
    [
        ("robot[0].path", 'path = "{}"'),
        ("robot[0].launch[0]", 'path = "r.urdf"\nlaunch = ["{}"]'),
        ("robot[0].controllers[0]", 'path = "r.urdf"\ncontrollers = ["{}"]'),
    ],
)
@pytest.mark.parametrize("path", ["/etc/passwd", "../home/x", "../home/none"])
def test_a_robots_file_outside_is_refused_with_the_way_out(folder: Folder, key: str, text: str, path: str) -> None:
    folder.write({"pull/.git/HEAD": "", "pull/r.urdf": ROBOT, "home/x": "secret\n"})
    folder.write({"pull/urdfctl.toml": f"[[robot]]\n{text.format(path)}\n"})
    assert refused(folder, "lint", ".") == (
        f"urdfctl.toml: {key}: file '{path}' is outside the workspace; name it on the command line, or use a wider "
        "--workspace"
    )


def test_a_configuration_of_a_repository_above_names_what_is_in_that(folder: Folder) -> None:
    folder.write({"pull/.git/HEAD": "", "pull/urdfctl.toml": 'package-paths = ["vendor"]\n', "pull/vendor/parts/x": ""})
    folder.write({name.replace("opt/", "pull/vendor/"): text for name, text in PROJECT.items()})
    folder.write({"pull/deep/r.xacro": PROJECT["pull/r.xacro"]})
    assert read(folder, "deep/r.xacro") == {"r.xacro"}


@needs_links
def test_a_configuration_that_leads_out_is_refused_with_the_way_out(folder: Folder) -> None:
    folder.write({"pull/.git/HEAD": "", "pull/r.urdf": ROBOT, "home/urdfctl.toml": 'distro = "jazzy"\n'})
    (folder.path / "pull/urdfctl.toml").symlink_to("../home/urdfctl.toml")
    assert refused(folder, "lint", ".") == (
        "urdfctl.toml: leads outside the workspace; name what it leads to: --config FILE"
    )
    assert refused(folder, "lint", "r.urdf", "--config", "urdfctl.toml") == (
        "'urdfctl.toml' leads outside the workspace; name what it leads to"
    )
    assert folder.run("lint", "r.urdf", "--config", "../home/urdfctl.toml", cwd=folder.path / "pull").returncode == 0


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes in its file system")
def test_a_configuration_that_is_no_file_or_too_large_is_not_read(folder: Folder) -> None:
    folder.write({"pull/.git/HEAD": "", "pull/r.urdf": ROBOT})
    os.mkfifo(folder.path / "pull/urdfctl.toml")
    assert read(folder, ".") == {"r.urdf"}
    (folder.path / "pull/urdfctl.toml").unlink()
    folder.write({"pull/urdfctl.toml": "#" * (1 << 20) + "\n"})
    assert refused(folder, "lint", ".") == "urdfctl.toml: larger than 1 MiB"
