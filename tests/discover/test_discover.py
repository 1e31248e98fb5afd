"""Paths mean robots, folders mean the robots in them, and no path means the package around the current folder."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from folder import Folder

from urdfctl.discover.launch_files import only_mentioned
from urdfctl.discover.robots import DiscoveredFiles, discover_files
from urdfctl.errors import UserError

ROBOT = '<robot name="r"><link name="a"/></robot>'
INCLUDES = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="{}"/></robot>'

WHEEL = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="name radius"><link name="${name}"/></xacro:macro>
</robot>
"""
CALLS_WHEEL = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="wheel.xacro"/>
  <link name="base"/>
  <xacro:wheel name="left"/>
</robot>
"""


def package(name: str) -> str:
    return f"<package><name>{name}</name></package>"


def roots(*paths: str) -> list[str]:
    return [os.path.normpath(path) for path in discover_files(paths or (".",)).candidates]


def launches() -> list[str]:
    return [os.path.normpath(path) for path in discover_files((".",)).launch_candidates]


def test_each_kind_of_file_is_known_by_its_name(folder: Folder) -> None:
    names = "a.urdf b.xacro c.urdf.xacro d.yaml e.yml f.launch g.launch.xml h.launch.py i.launch.yaml j".split()
    folder.write(dict.fromkeys(names, ""))
    found = discover_files(names)
    assert found.robots == ["a.urdf", "b.xacro", "c.urdf.xacro", "j"]
    assert found.controllers == ["d.yaml", "e.yml"]
    assert found.launches == ["f.launch", "g.launch.xml", "h.launch.py", "i.launch.yaml"]


def test_a_path_that_does_not_exist_is_an_error_that_names_the_nearest(folder: Folder) -> None:
    folder.write({"urdf/robot.xacro": ROBOT})
    with pytest.raises(UserError) as missing:
        discover_files(["urdf/robto.xacro"])
    assert str(missing.value) == "file or folder 'urdf/robto.xacro' does not exist; did you mean 'robot.xacro'?"
    with pytest.raises(UserError) as missing:
        discover_files(["nowhere/robot.xacro"])
    assert str(missing.value) == "file or folder 'nowhere/robot.xacro' does not exist"


def test_a_broken_link_is_there_and_its_reading_tells_what_is_wrong(folder: Folder) -> None:
    os.symlink("nowhere", "robot.xacro")
    assert discover_files(["robot.xacro"]).robots == ["robot.xacro"]


def test_the_roots_of_a_folder_are_the_files_that_no_other_includes(folder: Folder) -> None:
    folder.write(
        {
            "package.xml": package("arm"),
            "urdf/one.xacro": INCLUDES.format("parts/wheel.xacro"),
            "urdf/two.xacro": INCLUDES.format("$(find arm)/urdf/parts/base.xacro"),
            "urdf/plain.urdf": ROBOT,
            "urdf/parts/wheel.xacro": ROBOT,
            "urdf/parts/base.xacro": ROBOT,
            "urdf/notes.xacro": "<notes/>",
            "urdf/other.txt": ROBOT,
        }
    )
    assert roots() == ["urdf/one.xacro", "urdf/plain.urdf", "urdf/two.xacro"]


def test_an_include_whose_path_is_worked_out_counts_for_what_it_may_mean(folder: Folder) -> None:
    folder.write(
        {
            "robot.xacro": INCLUDES.format("$(find arm)/urdf/${kind}/arm.xacro"),
            "urdf/long/arm.xacro": ROBOT,
            "urdf/arm.xacro": ROBOT,
            "other/arm.xacro": ROBOT,
        }
    )
    assert roots() == ["other/arm.xacro", "robot.xacro", "urdf/arm.xacro"]


def test_an_include_that_is_only_a_value_hides_nothing(folder: Folder) -> None:
    folder.write({"robot.xacro": INCLUDES.format("$(arg description)"), "arm.xacro": ROBOT})
    assert roots() == ["arm.xacro", "robot.xacro"]


def test_an_include_in_a_comment_hides_nothing(folder: Folder) -> None:
    folder.write({"robot.xacro": "<robot><!-- <xacro:include filename='arm.xacro'/> --></robot>", "arm.xacro": ROBOT})
    assert roots() == ["arm.xacro", "robot.xacro"]


def test_a_file_that_includes_itself_is_still_a_robot(folder: Folder) -> None:
    folder.write({"robot.xacro": INCLUDES.format("robot.xacro")})
    assert roots() == ["robot.xacro"]


HANGS = '<robot{}><link name="lens"/><joint name="j"><parent link="{}"/><child link="lens"/></joint></robot>'


@pytest.mark.parametrize(
    ("text", "is_robot"),
    [
        (HANGS.format("", "chassis"), False),
        (HANGS.format(' name="camera"', "chassis"), True),  # a robot with a misspelt link
        (HANGS.format("", "lens"), True),
        (HANGS.format("", "${parent}"), True),
        (HANGS.format("", "chassis").replace("</robot>", '<include filename="$(env BASE)"/></robot>'), True),
    ],
)
def test_an_accessory_that_hangs_on_a_link_of_another_file_is_no_robot(
    folder: Folder, text: str, is_robot: bool
) -> None:
    folder.write({"robot.urdf": ROBOT, "camera.xacro": text})
    assert roots() == (["camera.xacro"] if is_robot else []) + ["robot.urdf"]


def test_an_accessory_without_a_name_whose_include_is_commented_out_is_no_robot(folder: Folder) -> None:
    include = "<!-- <xacro:include filename='$(find arm)/camera.xacro'/> -->"
    folder.write({"robot.urdf": f"<robot>{include}</robot>", "camera.xacro": HANGS.format("", "lens")})
    assert roots() == ["robot.urdf"]


@pytest.mark.parametrize(("include", "robots"), [("<!-- {} -->", ["robot.urdf"]), ("", ["part.xacro", "robot.urdf"])])
def test_a_part_with_parts_of_its_own_is_no_robot_where_its_include_is_commented_out(
    folder: Folder, include: str, robots: list[str]
) -> None:
    left_out = include.format("<xacro:include filename='part.xacro'/>")
    folder.write({"robot.urdf": f'<robot name="r">{left_out}<link name="a"/></robot>', "wheel.xacro": WHEEL})
    folder.write({"part.xacro": INCLUDES.format("wheel.xacro")})
    assert roots() == robots


def test_an_accessory_that_a_launch_file_loads_is_a_robot(folder: Folder) -> None:
    launch = '<launch><param name="robot_description" textfile="$(find arm)/camera.urdf"/></launch>'
    folder.write({"camera.urdf": HANGS.format("", "chassis"), "show.launch": launch})
    assert roots() == ["camera.urdf"]


def test_an_include_from_another_package_hides_only_the_file_of_that_package(folder: Folder) -> None:
    folder.write(
        {
            "arm/package.xml": package("arm"),
            "arm/urdf/robot.xacro": ROBOT,
            "cell/package.xml": package("cell"),
            "cell/urdf/robot.xacro": INCLUDES.format("$(find arm)/urdf/robot.xacro"),
        }
    )
    assert roots() == ["cell/urdf/robot.xacro"]


def test_what_is_built_hidden_or_marked_to_be_ignored_is_passed_over(folder: Folder) -> None:
    folder.write(
        {
            "src/arm.xacro": ROBOT,
            "build/arm.xacro": ROBOT,
            "install/arm.xacro": ROBOT,
            ".cache/arm.xacro": ROBOT,
            "old/COLCON_IGNORE": "",
            "old/deep/arm.xacro": ROBOT,
        }
    )
    assert roots() == ["src/arm.xacro"]


def test_a_circle_of_linked_folders_ends(folder: Folder) -> None:
    folder.write({"urdf/arm.xacro": ROBOT})
    os.symlink("..", "urdf/up")
    assert roots() == ["urdf/arm.xacro"]


def test_without_a_path_the_package_around_the_current_folder_is_meant(
    folder: Folder, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder.write({"arm/package.xml": package("arm"), "arm/urdf/arm.xacro": ROBOT, "arm/config/x.yaml": ""})
    monkeypatch.chdir(folder.path / "arm/config")
    assert discover_files([]).candidates == ["../urdf/arm.xacro"]


def test_without_a_path_and_a_package_the_current_folder_is_meant(folder: Folder) -> None:
    folder.write({"urdf/arm.xacro": ROBOT})
    assert roots() == ["urdf/arm.xacro"]


def test_a_file_named_twice_or_named_and_found_is_one_robot_that_was_named(folder: Folder) -> None:
    folder.write({"arm.xacro": ROBOT})
    path = str(Path("arm.xacro").resolve())
    assert discover_files(["arm.xacro", "./arm.xacro"]).descriptions() == [(path, True)]
    assert discover_files([".", "arm.xacro"]).descriptions() == [(path, True)]


def test_the_files_that_no_robot_has_read_are_known(folder: Folder) -> None:
    folder.write({"robot.xacro": INCLUDES.format("used.xacro"), "used.xacro": ROBOT, "unused.xacro": ROBOT})
    found = discover_files(["."])
    read = [str(folder.path / name) for name in ("robot.xacro", "used.xacro")]
    assert found.unread(read) == [str(folder.path / "unused.xacro")]
    assert DiscoveredFiles().unread(read) == []


@pytest.mark.parametrize("word", ["<include ", "<!--", '<xacro:include filename="', "<link ", '<parent link="'])
def test_a_million_beginnings_without_an_end_are_searched_once(folder: Folder, word: str) -> None:
    folder.write({"robot.urdf": "<robot " + word * (1_000_000 // len(word))})  # one by one it would take hours
    assert roots(".") == ["robot.urdf"]


@pytest.mark.parametrize("name", ["COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE"])
def test_an_ignored_folder_is_linted_if_there_is_nothing_else(folder: Folder, name: str) -> None:
    folder.write({f"arm/{name}": "", "arm/urdf/arm.urdf": '<robot name="arm"><link name="a"/><link name="b"/></robot>'})
    ran = folder.run("lint", ".", "--format", "json", "--exit-zero")
    assert [target["robot"] for target in json.loads(ran.stdout)["targets"]] == ["arm/urdf/arm.urdf"]
    assert ran.stderr == "urdfctl: checked although COLCON_IGNORE or CATKIN_IGNORE leaves nothing else: ./arm\n"


def test_a_robot_of_a_folder_that_loses_all_but_one_link_by_a_fault_is_linted(folder: Folder) -> None:
    folder.write({"package.xml": package("p"), "wheel.xacro": WHEEL, "robot.xacro": CALLS_WHEEL})
    ran = folder.run("lint", ".", "--format", "concise")
    assert ran.stdout == "robot.xacro:4:3: error UC009 the macro call passes no value for 'radius'\n"
    assert ran.returncode == 1


@pytest.mark.parametrize(
    ("name", "text", "is_candidate"),
    [
        ("bad.launch.py", "def generate_launch_description(:\n    pass\n", True),
        ("xml.launch.py", "<?xml version='1.0'?>\n<!-- of the arm -->\n<launch/>", True),
        ("xml.py", "<launch/>", False),
        ("page.launch.py", "<html><launch/></html>", False),
        ("bad.launch", '<launch><node pkg="a" type="b" name="c"></launch>', True),
        ("sound.launch.py", "def generate_launch_description():\n    '\\d'\n", False),
        ("sound.launch", '<launch><node pkg="a" type="b" name="c"/></launch>', False),
        ("template.launch", "<launch>{% if sim %}<node>{% endif %}</launch>", False),
    ],
)
def test_a_launch_file_that_cannot_be_parsed_is_always_read(
    folder: Folder, name: str, text: str, *, is_candidate: bool
) -> None:
    folder.write({"robot.urdf": ROBOT, f"launch/{name}": text})
    assert discover_files(["."]).launch_candidates == ([f"./launch/{name}"] if is_candidate else [])


def test_the_launch_files_of_the_setup_assistant_are_one_start(folder: Folder) -> None:
    text = """from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_{0}_launch


def generate_launch_description():
    return generate_{0}_launch(MoveItConfigsBuilder("arm", package_name="arm_moveit").to_moveit_configs())
"""
    kinds = ("demo", "move_group", "rsp", "spawn_controllers", "setup_assistant", "moveit_rviz")
    folder.write({f"launch/{kind}.launch.py": text.format(kind) for kind in kinds})
    assert launches() == ["launch/demo.launch.py"]
    (folder.path / "launch/demo.launch.py").unlink()
    assert launches() == [f"launch/{kind}.launch.py" for kind in ("move_group", "rsp", "spawn_controllers")]


STARTS = "def generate_launch_description():\n    # robot_state_publisher\n    return {}\n"
SHARE = "os.path.join(get_package_share_directory({}), 'launch', 'gazebo.launch.py')"
ARM_AND_CELL = "arm/launch/gazebo.launch.py", "cell/launch/gazebo.launch.py"


@pytest.mark.parametrize(
    "included",
    [
        SHARE.format("'simulation'"),
        SHARE.format("package='simulation'"),
        "PathJoinSubstitution([FindPackageShare('simulation'), 'launch', 'gazebo.launch.py'])",
        "[get_package_share_directory('simulation'), '/launch/gazebo.launch.py']",
        f"arm_cell_share, {SHARE.format('package')}; package = 'simulation'",
        "os.path.join(share, 'launch', 'gazebo.launch.py'); share = get_package_share_directory('simulation')",
        "f'{share}/launch/gazebo.launch.py'; share = get_package_share_path('simulation')",
        "share / 'launch' / 'gazebo.launch.py'; share = FindPackageShare(package='simulation').find('simulation')",
    ],
)
def test_a_launch_file_is_not_included_by_one_that_includes_its_namesake_in_another_package(
    included: str, folder: Folder
) -> None:
    """The launch file also names both packages otherwise, and the file that it includes is not always here."""
    outer = STARTS.format(f"{included}  # arm cell")
    own = dict.fromkeys(ARM_AND_CELL, STARTS.format("None"))
    folder.write({**own, "cell/launch/bringup.launch.py": outer})
    assert launches() == [ARM_AND_CELL[0], "cell/launch/bringup.launch.py", ARM_AND_CELL[1]]
    folder.write({"simulation/launch/gazebo.launch.py": STARTS.format("None")})
    assert launches() == [ARM_AND_CELL[0], "cell/launch/bringup.launch.py", ARM_AND_CELL[1]]


def test_a_launch_file_in_yaml_is_not_included_by_one_that_includes_its_namesake(folder: Folder) -> None:
    include = "- include:\n    file: $(find-pkg-share {})/launch/gazebo.launch.py\n"
    outer = "launch:\n- node: {{pkg: robot_state_publisher}}\n" + include
    folder.write({"arm/launch/gazebo.launch.py": STARTS.format("None")})
    folder.write({"arm/launch/bringup.launch.yaml": outer.format("gazebo_ros")})
    assert launches() == ["arm/launch/bringup.launch.yaml", "arm/launch/gazebo.launch.py"]
    folder.write({"arm/launch/bringup.launch.yaml": outer.format("arm")})
    assert launches() == ["arm/launch/bringup.launch.yaml"]


def test_a_launch_file_in_xml_is_not_included_by_one_that_includes_its_namesake(folder: Folder) -> None:
    world = '<launch><node pkg="robot_state_publisher" type="robot_state_publisher" name="r"/>{}</launch>'
    include = '<include file="$(find {})/launch/empty_world.launch"/>'
    folder.write({"arm/launch/empty_world.launch": world.format(include.format("gazebo_ros"))})
    folder.write({"arm/launch/bringup.launch": world.format(include.format("gazebo_ros"))})
    assert launches() == ["arm/launch/bringup.launch", "arm/launch/empty_world.launch"]
    folder.write({"arm/launch/bringup.launch": world.format(include.format("arm"))})
    assert launches() == ["arm/launch/bringup.launch"]


NODE = '<launch><node pkg="robot_state_publisher" {}="robot_state_publisher"/></launch>'


def test_the_ending_launch_xml_says_only_in_ros_1_that_others_include_a_file() -> None:
    texts = {"old/parts.launch.xml": NODE.format("type").encode(), "new/parts.launch.xml": NODE.format("exec").encode()}
    assert only_mentioned(texts, ()) == ["new/parts.launch.xml"]


def test_the_launch_files_beside_a_demo_of_moveit_belong_to_it() -> None:
    publishing = b'Node(package="robot_state_publisher")'
    texts = dict.fromkeys(("a/rsp.launch.py", "a/start.launch.py", "b/rsp.launch.py"), publishing)
    demo = {"a/demo.launch.py": b"return generate_demo_launch(moveit_config)"}
    assert only_mentioned({**demo, **texts}, demo) == ["a/start.launch.py", "b/rsp.launch.py"]
