"""The arguments with which READMEs and scripts start launch files."""

from __future__ import annotations

import json

import pytest
from folder import Folder

from urdfctl.discover.documented import Documentation

ROBOT = '<robot name="{0}"><link name="a"/><link name="b"/><joint name="j" type="fixed">{1}</joint></robot>'
ENDS = '<parent link="a"/><child link="b"/>'
LAUNCH = """\
<launch>
  <arg name="model" {default}/>
  <param name="robot_description" textfile="$(dirname)/$(arg model).urdf"/>
  <node pkg="controller_manager" type="spawner" name="s" args="arm_controller"/>
</launch>
"""
MANIFEST = "<package format='2'><name>arm</name></package>"


def documented(folder: Folder, text: str, name: str = "README.md", package: str = "arm") -> list[dict[str, str]]:
    """The arguments that a text gives the launch file of a package, where only the text is in the searched folders."""
    folder.write({"arm/package.xml": MANIFEST.replace("arm", package), "arm/launch/go.launch": "<launch/>", name: text})
    texts = Documentation([str(folder.path / name)])
    return [dict(one.arguments) for one in texts.starts(str(folder.path / "arm/launch/go.launch"))]


@pytest.mark.parametrize(
    ("text", "arguments"),
    [
        ("roslaunch arm go.launch model:=small", {"model": "small"}),
        ("Type `roslaunch arm go.launch model:=small`.", {"model": "small"}),
        ("$ ros2 launch arm go.launch model:=small sim:=true  # slow", {"model": "small", "sim": "true"}),
        ("ros2 launch --noninteractive arm go.launch model:=small", {"model": "small"}),
        (
            "roslaunch arm go.launch \\\n    model:=small \\\n    sim:=true\nmodel:=large",
            {"model": "small", "sim": "true"},
        ),
        ("roslaunch src/arm/launch/go.launch model:=small", {"model": "small"}),
        ("roslaunch arm go.launch name:='my arm' model:=\"small\".", {"name": "my arm", "model": "small"}),
        ("roslaunch arm go.launch model:=small && rosrun x y z:=1", {"model": "small"}),
        ("roslaunch arm go.launch ip:=<ip> model:=small", {"model": "small"}),
        (
            "roslaunch arm go.launch model:=UR5 side:=LEFT_ARM port:=TTY",
            {"model": "UR5", "side": "LEFT_ARM", "port": "TTY"},
        ),
    ],
)
def test_a_command_names_arguments(text: str, arguments: dict[str, str], folder: Folder) -> None:
    assert documented(folder, text) == [arguments]


@pytest.mark.parametrize(
    "text",
    [
        "roslaunch arm go.launch",
        "roslaunch leg go.launch model:=small",
        "roslaunch arm stop.launch model:=small",
        "roslaunch arm go.launch model:=<model>",
        "roslaunch arm go.launch model:=$MODEL",
        "roslaunch arm go.launch sim:=[true|false]",
        "roslaunch arm go.launch sim:=true/false",
        "roslaunch arm go.launch name:=your_name",
        "roslaunch arm go.launch model:=MODEL",
        "roslaunch arm go.launch robot:=ROBOT_NAME",
        "rosrun arm go.launch model:=small",
    ],
)
def test_another_command_and_a_value_that_the_reader_chooses_name_none(text: str, folder: Folder) -> None:
    assert documented(folder, text) == []


def test_a_launch_file_that_a_text_names_by_its_path_is_the_one_beside_the_text(folder: Folder) -> None:
    readme = "ros2 launch go.launch model:={}"
    for name in ("left", "right"):
        folder.write({f"{name}/go.launch": "<launch/>", f"{name}/README.md": readme.format(name)})
    folder.write({"other/go.launch": "<launch/>", "README.md": readme.format("any")})
    texts = Documentation([str(folder.path / name / "README.md") for name in ("left", "right", "")])

    def models(name: str) -> list[str]:
        return [dict(one.arguments)["model"] for one in texts.starts(str(folder.path / name / "go.launch"))]

    assert (models("left"), models("right"), models("other")) == (["left", "any"], ["right", "any"], ["any"])


def test_each_choice_counts_once_and_the_nearest_text_first(folder: Folder) -> None:
    first = "roslaunch arm go.launch a:=1 b:=2\nroslaunch arm go.launch b:=2 a:=1\nroslaunch arm go.launch a:=2"
    folder.write({"arm/README.md": "roslaunch arm go.launch a:=3"})
    assert documented(folder, first) == [{"a": "3"}, {"a": "1", "b": "2"}, {"a": "2"}]


@pytest.mark.parametrize("name", ["README.rst", "docs/use.md", "scripts/run.sh", "Makefile", "docker/Dockerfile"])
def test_texts_in_the_folders_around_a_launch_file_count_wherever_the_search_begins(name: str, folder: Folder) -> None:
    folder.write({f"arm/{name}": "roslaunch arm go.launch model:=small"})
    assert documented(folder, "", name="other/README.md") == [{"model": "small"}]


def started(folder: Folder, readme: str, launch: str, *paths: str) -> list[tuple[dict[str, str], str]]:
    """What a launch file starts, as `urdfctl show` has it: its arguments, and the name of the description."""
    robots = {f"arm/launch/{name}.urdf": ROBOT.format(name, ENDS) for name in ("small", "large", "other")}
    folder.write({**robots, "arm/package.xml": MANIFEST, "arm/launch/go.launch": launch, "README.md": readme})
    shown = folder.run("show", "--format", "json", *(paths or (".",)))
    targets = json.loads(shown.stdout)["targets"]
    found = [(one["launch_arguments"], one["robot"]) for one in targets if one["launch"]]
    return [(arguments, robot.rpartition("/")[2]) for arguments, robot in found]


def test_a_launch_file_is_checked_with_its_defaults_and_as_it_is_documented(folder: Folder) -> None:
    readme = "roslaunch arm go.launch model:=large\nroslaunch arm go.launch model:=small\nroslaunch arm go.launch x:=1"
    found = started(folder, readme, LAUNCH.format(default='default="small"'))
    assert found == [({}, "small.urdf"), ({"model": "large"}, "large.urdf")]


def test_show_says_where_the_arguments_are_documented(folder: Folder) -> None:
    readme = "# Arm\n\n    roslaunch arm go.launch model:=large\n"
    started(folder, readme, LAUNCH.format(default='default="small"'))
    assert "  arguments   model:=large  (as in README.md:3)\n" in folder.run("show", ".").stdout
    targets = json.loads(folder.run("show", "--format", "json", ".").stdout)["targets"]
    assert [one["arguments_from"] for one in targets if one["launch"]] == [None, "README.md:3"]


def test_a_launch_file_that_needs_an_argument_is_not_checked_without_it(folder: Folder) -> None:
    optional = LAUNCH.format(default='default="small"').replace("<launch>", '<launch><arg name="ip"/>')
    assert started(folder, "roslaunch arm go.launch ip:=10.0.0.1", optional) == [({"ip": "10.0.0.1"}, "small.urdf")]


def test_a_documented_argument_that_leads_to_no_file_is_left_out(folder: Folder) -> None:
    launch = LAUNCH.format(default='default="small"')
    assert started(folder, "roslaunch arm go.launch model:=huge", launch) == [({}, "small.urdf")]


def test_an_included_launch_file_that_people_start_alone_is_checked_so(folder: Folder) -> None:
    outer = "<launch><include file='$(find arm)/launch/go.launch'/></launch>"
    folder.write({"arm/launch/all.launch": outer})
    found = started(folder, "roslaunch arm go.launch model:=large", LAUNCH.format(default='default="small"'))
    assert found == [({}, "small.urdf"), ({"model": "large"}, "large.urdf")]


def test_a_guessed_file_that_is_only_a_part_is_no_robot(folder: Folder) -> None:
    macro = '<xacro:macro name="m"><link name="a"/></xacro:macro>'
    folder.write({"arm/launch/part.urdf": f'<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{macro}</robot>'})
    found = started(folder, "", LAUNCH.format(default=""))
    assert [name for _, name in found] == ["large.urdf", "other.urdf", "small.urdf"]


NEEDS_TWO = """\
<launch>
  <arg name="model"/>
  <arg name="sim" default="true"/>
  <param name="robot_description" textfile="$(dirname)/$(arg model).urdf"/>
  <node unless="$(arg sim)" pkg="controller_manager" type="spawner" name="s" args="arm_controller"/>
</launch>
"""


def test_a_command_without_the_argument_that_decides_which_robot_it_is_starts_nothing(folder: Folder) -> None:
    found = started(folder, "roslaunch arm go.launch model:=<model> sim:=false", NEEDS_TWO)
    assert [arguments for arguments, _ in found] == [{"model": name} for name in ("large", "other", "small")]


def test_a_guess_stays_beside_a_documented_start_of_the_same_robot_in_another_mode(folder: Folder) -> None:
    found = started(folder, "roslaunch arm go.launch model:=small sim:=false", NEEDS_TWO)
    assert ({"model": "small", "sim": "false"}, "small.urdf") in found
    assert ({"model": "small"}, "small.urdf") in found
    needy = NEEDS_TWO.replace('name="sim" default="true"', 'name="sim"')
    found = started(folder, "roslaunch arm go.launch model:=small sim:=false", needy)
    assert ({"model": "small"}, "small.urdf") not in found


CHOOSING = """\
<launch>
  <arg name="moving" default="true"/>
  <param name="robot_description" textfile="$(dirname)/small.urdf"/>
  <node if="$(arg moving)" pkg="controller_manager" type="spawner" name="s" args="arm_controller"/>
</launch>
"""
STILL = "<launch><include file='$(find arm)/launch/go.launch'><arg name='moving' value='false'/></include></launch>"


def spawned(folder: Folder, readme: str, launch: str, outer: str = STILL) -> list[tuple[str, list[str], str | None]]:
    """What each launch file spawns, and where a text starts it, beside another one that includes it."""
    folder.write({"arm/launch/still.launch": outer})
    started(folder, readme, launch)
    targets = json.loads(folder.run("show", "--format", "json", ".").stdout)["targets"]
    launched = [one for one in targets if one["launch"]]
    return sorted((one["launch"].rpartition("/")[2], one["spawned"], one["arguments_from"]) for one in launched)


def test_an_included_launch_file_that_people_start_without_arguments_is_checked_with_its_defaults(
    folder: Folder,
) -> None:
    found = spawned(folder, "# Arm\nroslaunch arm go.launch", CHOOSING)
    assert found == [("go.launch", ["arm_controller"], "README.md:2"), ("still.launch", [], None)]
    assert "  arguments   none  (as in README.md:2)\n" in folder.run("show", ".").stdout


@pytest.mark.parametrize(
    ("readme", "launch", "outer"),
    [
        ("roslaunch arm go.launch moving:=<yes or no>", CHOOSING, STILL),
        ("roslaunch arm still.launch", CHOOSING, STILL),
        ("roslaunch arm go.launch", CHOOSING, STILL.replace("false", "true")),
        ("roslaunch arm go.launch", CHOOSING.replace('if="$(arg moving)" ', ""), STILL),
    ],
)
def test_an_included_launch_file_is_not_checked_again_where_nothing_else_is_started(
    readme: str, launch: str, outer: str, folder: Folder
) -> None:
    assert [name for name, _, _ in spawned(folder, readme, launch, outer)] == ["still.launch"]


DEMO = """\
<launch>
  <!-- By default, we will load or override the robot_description -->
  <arg name="load_robot_description" default="true"/>
  <param if="$(arg load_robot_description)" name="robot_description" command="xacro {}"/>
  <node pkg="moveit_ros_move_group" type="move_group" name="move_group"/>
</launch>
"""
IN_GAZEBO = """\
<launch>
  <param name="robot_description" textfile="$(find arm)/launch/large.urdf"/>
  <include file="$(find arm)/launch/demo.launch"><arg name="load_robot_description" value="false"/></include>
</launch>
"""


@pytest.mark.parametrize(
    ("demo", "said"),
    [
        (DEMO.format("$(find arm)/launch/small.urdf"), "  description arm/launch/small.urdf\n"),
        (
            DEMO.format("$(find heron)/heron.urdf"),
            "demo.launch  (starts a robot of package 'heron', not in this workspace)\n",
        ),
    ],
)
def test_the_demo_of_moveit_for_ros_1_is_started_alone_although_that_for_gazebo_includes_it(
    folder: Folder, demo: str, said: str
) -> None:
    folder.write({"arm/launch/demo.launch": demo, "arm/launch/demo_gazebo.launch": IN_GAZEBO})
    started(folder, "# Arm", "<launch/>")
    shown = folder.run("show", ".").stdout
    assert said in shown
    assert "  description arm/launch/large.urdf\n" in shown


def test_the_demo_of_moveit_is_started_alone_though_another_one_publishes_the_same_robot(folder: Folder) -> None:
    demo = DEMO.format("$(find arm)/launch/small.urdf")
    folder.write({"arm/launch/demo.launch": demo, "arm/launch/demo_gazebo.launch": IN_GAZEBO})
    published = '<param name="robot_description" command="xacro $(find arm)/launch/small.urdf"/>'
    started(folder, "# Arm", f"<launch>{published}</launch>")
    assert "arm/launch/demo.launch\n  arguments   none" in folder.run("show", ".").stdout


def test_another_launch_file_with_the_name_demo_is_no_start_of_its_own(folder: Folder) -> None:
    demo = DEMO.format("$(find arm)/launch/small.urdf").replace("load_robot_description", "load")
    outer = IN_GAZEBO.replace("load_robot_description", "load")
    folder.write({"arm/launch/demo.launch": demo, "arm/launch/demo_gazebo.launch": outer})
    started(folder, "# Arm", "<launch/>")
    assert "description arm/launch/small.urdf" not in folder.run("show", ".").stdout
