"""Migrations over a distro between: they equal those at once, also over humble with Gazebo Classic."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from folder import CHECKOUT, Folder
from moved_packages import FILES
from ros1_packages import LEG, migrated

from urdfctl.migrate.launch.python_reading import read_python
from urdfctl.migrate.launch.xml_reading import read_xml
from urdfctl.source.span import SourceText


def over(folder: Folder, source: str, *distros: str, form: str = "py") -> dict[str, str]:
    """The files after a migration to each distro after the other, without the reports."""
    for number, distro in enumerate(distros):
        target = f"{'-'.join(distros[: number + 1])}-{form}"
        if not (folder.path / target).exists():
            ran = folder.run("migrate", source, "--to", distro, "--launch", form, "-o", target)
            assert ran.returncode == 0, ran.stderr
        source = target
    files = (path for path in (folder.path / source).rglob("*") if path.is_file() and path.name != "MIGRATION.md")
    return {path.relative_to(folder.path / source).as_posix(): path.read_text() for path in files}


@pytest.mark.parametrize("form", ["py", "xml"])
def test_a_robot_of_ros_1_becomes_the_same_for_gz_over_humble_with_gazebo_classic(folder: Folder, form: str) -> None:
    folder.write(FILES)
    between = over(folder, "arm", "humble", form=form)[f"launch/arm.launch.{form}"]
    assert "spawn_entity.py" in between
    at_once = over(folder, "arm", "lyrical", form=form)
    assert "parameter_bridge" in at_once[f"launch/arm.launch.{form}"]
    assert over(folder, "arm", "humble", "lyrical", form=form) == at_once


@pytest.mark.parametrize("sample", ["mybot", "my_robot"])
def test_a_sample_becomes_the_same_for_gz_over_humble_and_over_jazzy(folder: Folder, sample: str) -> None:
    shutil.copytree(CHECKOUT / "samples" / sample, folder.path / sample)
    at_once = over(folder, sample, "lyrical")
    assert over(folder, sample, "humble", "lyrical") == at_once
    assert over(folder, sample, "jazzy", "lyrical") == at_once


def test_a_launch_file_that_was_changed_after_its_migration_keeps_the_changes(folder: Folder) -> None:
    folder.write(FILES)
    over(folder, "arm", "humble")
    path = folder.path / "humble-py/launch/arm.launch.py"
    text = path.read_text()
    assert read_python(SourceText(str(path), text.encode())) is not None
    changed = text.replace("    return LaunchDescription(", "    answer = 42  # mine\n    return LaunchDescription(")
    assert read_python(SourceText(str(path), changed.encode())) is None
    path.write_text(changed)
    after = over(folder, "humble-py", "lyrical")["launch/arm.launch.py"]
    assert "    answer = 42  # mine\n" in after
    assert "gz_sim.launch.py" in after
    assert "gazebo_ros" not in after
    said = re.search(r'"gz_args": \[(.*)\]', after)
    assert said is not None
    assert said[1].split(", ") == [
        '"-v4 "',
        "PythonExpression([\"'' if '\"",
        'LaunchConfiguration("paused")',
        "\"' == 'true' else '-r '\"])",
        "PythonExpression([\"'' if '\"",
        'LaunchConfiguration("gui")',
        "\"' == 'true' else '-s '\"])",
        'LaunchConfiguration("world")',
    ]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "from launch import LaunchDescription\n",
        "def generate_launch_description(:\n",
        "def generate_launch_description():\n    return LaunchDescription([Node(**more)])\n",
        "def generate_launch_description():\n    return LaunchDescription([*nodes, other])\n",
        "def generate_launch_description():\n    return LaunchDescription(actions())\n",
        "def generate_launch_description():\n    return LaunchDescription([Node(remappings=[('a', 'b', 'c')])])\n",
        "def generate_launch_description():\n    return LaunchDescription([GroupAction()])\n",
        '"""Mine."""\n\n\ndef generate_launch_description():\n    return LaunchDescription([LogInfo(msg="a")])\n',
    ],
)
def test_a_launch_file_in_python_of_another_form_is_not_read(text: str) -> None:
    assert read_python(SourceText("a.launch.py", text.encode())) is None


@pytest.mark.parametrize(
    "text",
    ["", "<launch/>", "<!-- a --><launch/>", "<!-- a --><launch><executable cmd='ls'/></launch>", "<!-- a --><launch"],
)
def test_a_launch_file_in_xml_of_another_form_is_not_read(text: str) -> None:
    assert read_xml(SourceText("a.launch.xml", text.encode())) is None


def test_what_is_read_of_a_written_launch_file_is_all_of_it(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    folder.write(FILES)
    for form, read in (("py", read_python), ("xml", read_xml)):
        text = over(folder, "arm", "humble", form=form)[f"launch/arm.launch.{form}"]
        written = read(SourceText(f"arm.launch.{form}", text.encode()))
        assert written is not None
        kinds = [action.kind for action in written.actions if action.kind != "comment"]
        assert kinds == [
            *(
                "argument",
                "argument",
                "argument",
                "let",
                "argument",
                "argument",
                "argument",
                "set_parameter",
                "include",
            ),
            *("group", "node", "include"),
        ]


PARTS = ("urdf", "yaml", "launch", "manifest", "moveit")


def parts_of(folder: Folder, source: str, parts: tuple[str, ...], *words: str) -> dict[str, str]:
    """The files of a copy after a migration to lyrical of one part after the other, without the report."""
    shutil.copytree(folder.path / source, folder.path / "parts")
    for part in parts:
        ran = folder.run("migrate", "parts", "--to", "lyrical", "--only", part, "--in-place", "--force", *words)
        assert ran.returncode == 0, ran.stderr
    files = (path for path in (folder.path / "parts").rglob("*") if path.is_file() and path.name != "MIGRATION.md")
    return {path.relative_to(folder.path / "parts").as_posix(): path.read_text() for path in files}


def test_parts_of_a_robot_of_ros_1_that_are_migrated_one_after_the_other_equal_all_at_once(folder: Folder) -> None:
    folder.write(FILES)
    assert parts_of(folder, "arm", PARTS, "--from", "noetic") == over(folder, "arm", "lyrical")


def test_parts_of_a_robot_of_ros_2_equal_all_at_once_if_launch_files_come_after_descriptions(folder: Folder) -> None:
    folder.write(FILES)
    at_once = over(folder, "arm", "humble", "lyrical")
    assert parts_of(folder, "humble-py", ("moveit", "manifest", "yaml", "urdf", "launch")) == at_once


def test_components_of_several_files_are_numbered_in_the_order_of_the_files(folder: Folder) -> None:
    sides = "abcdef"
    includes = "".join(f'  <xacro:include filename="{side}.xacro"/>\n' for side in ["leg", *sides])
    wrapped = '<robot name="walker" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{}</robot>\n'.format
    legs = {
        f"urdf/{side}.xacro": wrapped(f'  <xacro:leg side="{side}"><origin xyz="0 1 0"/></xacro:leg>\n')
        for side in sides
    }
    robot = {"urdf/robot.xacro": wrapped(f'  <link name="body"/>\n{includes}'), "urdf/leg.xacro": wrapped(LEG)}
    after = migrated(folder, {**robot, **legs})
    names = [re.findall(r'<ros2_control name="(\w+)"', after[name]) for name in legs]
    assert names == [["walker_system"], *([f"walker_system_{number}"] for number in range(2, 7))]
