"""`urdfctl diff` compares what ROS reads of two robots, from files, folders, variants and git revisions."""

from __future__ import annotations

import json
import subprocess
from typing import Any

import pytest
from folder import Folder

BODY = """
  <link name="base"><inertial><mass value="2"/></inertial>
    <visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <link name="fore"/>
  <joint name="elbow" type="revolute"><parent link="base"/><child link="fore"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="5" velocity="SPEED"/></joint>
  <ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>
"""
ARM = f'<robot name="r">{BODY}</robot>\n'.replace("SPEED", "2.0")
VARIED = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="v" default="1"/>'
CONTROLLERS = """\
controller_manager:
  ros__parameters: {update_rate: 100, arm: {type: forward_command_controller/ForwardCommandController}}
arm: {ros__parameters: {joints: [elbow], interface_name: position}}
"""


def found(folder: Folder, *words: str) -> list[tuple[str, str, str, Any, Any]]:
    ran = folder.run("diff", *words, "--format", "json")
    assert ran.returncode == 0, ran.stderr
    return [
        (change["area"], change["kind"], change["path"], change["before"], change["after"])
        for robot in json.loads(ran.stdout)["robots"]
        for change in robot["changes"]
    ]


def changed(folder: Folder, *replacements: tuple[str, str]) -> list[tuple[str, str, str, Any, Any]]:
    text = ARM
    for old, new in replacements:
        assert old in text
        text = text.replace(old, new)
    folder.write({"a.urdf": ARM, "b.urdf": text})
    return found(folder, "a.urdf", "b.urdf")


def test_a_limit_that_changes_is_one_change(folder: Folder) -> None:
    assert changed(folder, ("2.0", "3")) == [("limits", "changed", "joint:elbow/limit/@velocity", "2.0", "3")]


def test_the_same_numbers_and_written_defaults_are_no_change(folder: Folder) -> None:
    assert changed(folder, ("2.0", "2"), ("<axis", '<origin xyz="0 0 0"/><axis'), ('"0 0 1"', '" 0 0  1.0"')) == []


def test_a_joint_that_is_renamed_everywhere_is_one_change(folder: Folder) -> None:
    assert changed(folder, ('"elbow"', '"wrist"')) == [("joints", "renamed", "joint:wrist", "elbow", "wrist")]


def test_a_joint_that_is_renamed_at_one_place_is_named_with_what_lost_it(folder: Folder) -> None:
    assert changed(folder, ('<joint name="elbow" type', '<joint name="wrist" type')) == [
        ("joints", "renamed", "joint:wrist", "elbow", "wrist")
    ]


def test_another_joint_in_the_same_place_is_not_the_renamed_one(folder: Folder) -> None:
    other = ('<joint name="elbow" type="revolute">', '<joint name="slide" type="prismatic">')
    ends = ('<child link="fore"/><axis xyz="0 0 1"/>', '<child link="hand"/><axis xyz="1 1 0"/>')
    links = ('<link name="fore"/>', '<link name="hand"><inertial><mass value="9"/></inertial></link>')
    kinds = [(area, kind, path) for area, kind, path, _, _ in changed(folder, other, ends, links, ("-1", "-9"))]
    assert ("joints", "added", "joint:slide") in kinds
    assert ("joints", "removed", "joint:elbow") in kinds


def test_hardware_interfaces_and_geometry_have_their_areas(folder: Folder) -> None:
    edits = [
        ("mock_components/GenericSystem", "my/Hw"),
        ('<command_interface name="position"/>', ""),
        ("1 1 1", "1 1 2"),
    ]
    assert [(area, kind, path) for area, kind, path, _, _ in changed(folder, *edits)] == [
        ("geometry", "changed", "link:base/visual/geometry/box/@size"),
        ("interfaces", "removed", "ros2_control:hw/joint:elbow/command_interface:position"),
        ("hardware", "changed", "ros2_control:hw/hardware/plugin"),
    ]


def test_a_shape_with_another_name_and_size_is_still_the_same_shape(folder: Folder) -> None:
    shape = '<visual name="{}"><geometry><box size="{}"/></geometry></visual>'
    edit = ("</visual>", f"</visual>{shape.format('one', '2 2 2')}")
    folder.write({"a.urdf": ARM.replace(*edit), "b.urdf": ARM.replace(*edit).replace("2 2 2", "2 2 3")})
    assert found(folder, "a.urdf", "b.urdf") == [
        ("geometry", "changed", "link:base/visual[2]/geometry/box/@size", "2 2 2", "2 2 3")
    ]


def test_variants_of_one_file_are_compared(folder: Folder) -> None:
    folder.write({"r.xacro": f"{VARIED}{BODY.replace('SPEED', '$(arg v)')}</robot>"})
    assert found(folder, "r.xacro", "v:=3", "r.xacro") == [
        ("limits", "changed", "joint:elbow/limit/@velocity", "3", "1")
    ]


def test_controllers_of_the_launch_files_are_compared(folder: Folder) -> None:
    launch = """<launch><node pkg="controller_manager" exec="ros2_control_node">
        <param name="robot_description" value="$(command 'xacro $(dirname)/r.urdf')"/>
        <param from="$(dirname)/c.yaml"/></node>
        <node pkg="controller_manager" exec="spawner" args="arm"/></launch>"""
    files = {"r.urdf": ARM, "c.yaml": CONTROLLERS, "up.launch.xml": launch}
    folder.write({f"old/{name}": text for name, text in files.items()})
    files["c.yaml"] = CONTROLLERS.replace("100", "200").replace("interface_name: position", "interface_name: velocity")
    files["up.launch.xml"] = launch.replace("spawner", "spawner.py").replace('args="arm"', 'args="arm --inactive"')
    folder.write({f"new/{name}": text for name, text in files.items()})
    assert {one[:3] for one in found(folder, "old/up.launch.xml", "new/up.launch.xml")} == {
        ("controllers", "changed", "manager:controller_manager/@update_rate"),
        ("controllers", "changed", "controller:arm/@interface_name"),
        ("started", "removed", "started:/arm"),
        ("started", "removed", "node_started:controller_manager/spawner"),
        ("started", "added", "node_started:controller_manager/spawner.py"),
    }


def test_folders_are_compared_robot_by_robot(folder: Folder) -> None:
    folder.write({"one/a.urdf": ARM, "one/b.urdf": ARM, "two/a.urdf": ARM.replace("2.0", "4"), "two/c.urdf": ARM})
    shown = folder.run("diff", "one", "two").stdout.splitlines()
    assert shown == [
        "- robot b.urdf",
        "+ robot c.urdf",
        "limits:",
        "  ~ joint:elbow/limit/@velocity: 2.0 → 4",
        "1 change, 1 robot removed, 1 robot added from one to two",
    ]


@pytest.fixture
def repository(folder: Folder) -> Folder:
    folder.write({"pkg/r.urdf": ARM, "pkg/mesh.stl": "solid"})
    for words in (["init", "-q", "-b", "mainline"], ["add", "."], ["commit", "-q", "-m", "first"]):
        subprocess.run(["git", "-c", "user.name=n", "-c", "user.email=n@n", *words], cwd=folder.path, check=True)
    folder.write({"pkg/r.urdf": ARM.replace("2.0", "2.5")})
    return folder


@pytest.mark.parametrize("before", ["HEAD:", "mainline:pkg/r.urdf", "HEAD~0:pkg/r.urdf"])
def test_a_git_revision_is_compared_with_the_file_as_it_is(repository: Folder, before: str) -> None:
    assert found(repository, before, "pkg/r.urdf") == [
        ("limits", "changed", "joint:elbow/limit/@velocity", "2.0", "2.5")
    ]
    assert found(repository, before, "HEAD:pkg/r.urdf") == []


def test_a_pull_request_gets_a_table_and_a_page(folder: Folder) -> None:
    folder.write({"a.urdf": ARM, "b.urdf": ARM.replace("2.0", "3")})
    ran = folder.run(
        "diff", "a.urdf", "b.urdf", "--format", "markdown", "--format", "html=d.html", "--fail-on", "joints"
    )
    assert "| limits | `joint:elbow/limit/@velocity` | `2.0` | `3` |" in ran.stdout
    assert "<code>joint:elbow/limit/@velocity</code>" in (folder.path / "d.html").read_text(encoding="utf-8")
    assert ran.returncode == 0
    assert folder.run("diff", "a.urdf", "b.urdf", "--fail-on", "joints,limits").returncode == 1
    assert folder.run("diff", "a.urdf", "a.urdf", "--fail-on", "any").returncode == 0


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("r.urdf",), "diff needs two robots: urdfctl diff A B; each is a file, a folder, or a revision"),
        (("pkg/r.urdf", "t.urdf"), "file or folder 't.urdf' does not exist"),
        (("mainlin:", "pkg/r.urdf"), "git revision 'mainlin' does not exist; did you mean 'mainline'?"),
        (("HEAD:pkg/none.urdf", "pkg/r.urdf"), "git revision 'HEAD' has no 'pkg/none.urdf'"),
        (("pkg", "pkg/r.urdf"), "'pkg' and 'pkg/r.urdf' must both be files, or both be folders"),
        (("pkg/mesh.stl", "pkg/r.urdf"), "'pkg/mesh.stl' is a mesh; name the robot's URDF or xacro"),
        (
            ("pkg/r.urdf", "pkg/r.urdf", "--fail-on", "limts"),
            "unknown area 'limts' in --fail-on; did you mean 'limits'?",
        ),
    ],
)
def test_what_cannot_be_compared_gets_one_line(repository: Folder, words: tuple[str, ...], said: str) -> None:
    ran = repository.run("diff", *words)
    assert ran.returncode == 2
    assert ran.stderr.startswith(f"urdfctl: {said}")
    assert ran.stderr.count("\n") == 1


def test_a_joint_in_a_link_is_compared_as_it_is_written(folder: Folder) -> None:
    folder.write({"r.urdf": "<robot name='r'><link name='base'><joint name='j'/></link></robot>"})
    ran = folder.run("diff", "r.urdf", "r.urdf")
    assert (ran.returncode, ran.stderr) == (0, "")
