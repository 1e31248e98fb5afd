"""A launch file that needs arguments is started with those for which files exist."""

from __future__ import annotations

from pathlib import Path

import pytest
from folder import Folder

from urdfctl.config.settings import Settings
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target

NEEDS_MODEL = """\
<launch>
  <arg name="model" {}/>
  <arg name="name" default="$(arg model)"/>
  <arg name="simulated" default="false"/>
  <arg name="real" default="false"/>
  {}
</launch>
"""
DESCRIPTION = '<param name="$(arg name)/robot_description" command="xacro $(dirname)/$(arg model).urdf.xacro"/>'
CONTROLLERS = '<rosparam if="$(arg {})" file="$(dirname)/{}.yaml" ns="$(arg name)"/>'
ROBOT = '<robot name="r"><link name="base"/></robot>'


def variants(folder: Folder, text: str, **others: str) -> list[dict[str, str]]:
    """The arguments of each variant of a launch file beside two robots."""
    robots = {f"{name}.urdf.xacro": ROBOT for name in ("small", "large")}
    folder.write({**robots, **others, "l.launch": text})
    targets = Loader(Settings()).variants(Target(str(folder.path / "l.launch")))
    assert all(target.guessed is bool(target.arguments) for target in targets)
    return [dict(target.arguments) for target in targets]


@pytest.mark.parametrize("default", ["", 'default=""'])
def test_values_come_from_the_files_that_exist(folder: Folder, default: str) -> None:
    found = variants(folder, NEEDS_MODEL.format(default, DESCRIPTION))
    assert found == [{"model": "large"}, {"model": "small"}]


def test_a_backup_is_no_choice(folder: Folder) -> None:
    described = DESCRIPTION.replace(".urdf.xacro", "")
    found = variants(folder, NEEDS_MODEL.format("", described), **{"small.urdf.xacro.bak": ROBOT, "small.old": ROBOT})
    assert found == [{"model": "large.urdf.xacro"}, {"model": "small.urdf.xacro"}]


@pytest.mark.parametrize(
    ("default", "found"),
    [
        ("$(optenv MODEL none)", [{"model": "large"}, {"model": "small"}]),
        ("$(optenv MODEL small)", [{}]),
        ("none", [{}]),
    ],
)
def test_a_variable_of_the_environment_that_is_not_given_is_chosen_like_a_required_argument(
    folder: Folder, default: str, found: list[dict[str, str]]
) -> None:
    assert variants(folder, NEEDS_MODEL.format(f'default="{default}"', DESCRIPTION)) == found


def test_a_launch_file_with_a_robot_needs_none(folder: Folder) -> None:
    assert variants(folder, NEEDS_MODEL.format('default="small"', DESCRIPTION)) == [{}]


def test_values_come_from_parameter_files_if_the_description_is_the_same_for_all(folder: Folder) -> None:
    inside = (
        '<param name="robot_description" command="xacro $(dirname)/small.urdf.xacro model:=$(arg model)"/>'
        '<node pkg="p" type="t" name="n"><rosparam file="$(dirname)/$(arg model)/limits.yaml"/></node>'
    )
    files = {"left/limits.yaml": "a: 1", "right/limits.yaml": "a: 1"}
    assert variants(folder, NEEDS_MODEL.format("", inside), **files) == [{"model": "left"}, {"model": "right"}]
    assert variants(folder, NEEDS_MODEL.format('default=""', inside), **files) == [{}]
    assert variants(folder, NEEDS_MODEL.format("", inside.replace("$(arg model)/", "some/")), **files) == [{}]


NEEDS_KIND = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="model" default="none"/>
  <xacro:include filename="$(arg model)/parts.xacro"/>
</robot>
"""


def test_a_robot_whose_parts_an_argument_decides_is_linted_with_its_values_and_never_called_complete(
    folder: Folder,
) -> None:
    start = '<launch><arg name="model"/>{}<param name="robot_description" command="{}"/></launch>'
    command = "xacro $(dirname)/r.urdf.xacro model:=$(arg model)"
    loading = '<rosparam file="$(dirname)/$(arg model)/limits.yaml"/>'
    parts = "<robot><link name='base'/><link name='base'/></robot>"
    files = {"small/parts.xacro": parts, "small/limits.yaml": "a: 1", "r.urdf.xacro": NEEDS_KIND}
    folder.write({**files, "l.launch": start.format("", command)})
    assert "some parts are not known" in folder.run("lint", "--select", "UC110").stdout
    folder.write({"l.launch": start.format(loading, command)})
    assert "error UC110" in folder.run("lint", "--select", "UC110").stdout


def test_without_any_file_nothing_is_guessed(folder: Folder) -> None:
    text = NEEDS_MODEL.format("", DESCRIPTION.replace("$(arg model)", "$(arg model)_arm"))
    assert variants(folder, text) == [{}]


def test_what_is_off_by_default_is_switched_on_where_it_starts_controllers(folder: Folder) -> None:
    inside = DESCRIPTION + CONTROLLERS.format("simulated", "a") + CONTROLLERS.format("real", "b")
    assert variants(folder, NEEDS_MODEL.format("", inside)) == [
        {"model": "large", "simulated": "true"},
        {"model": "small", "simulated": "true"},
        {"model": "large", "real": "true"},
    ]


def test_a_value_for_which_a_loaded_file_is_missing_is_none(folder: Folder) -> None:
    inside = DESCRIPTION + '<rosparam file="$(dirname)/$(arg model).yaml"/>'
    assert variants(folder, NEEDS_MODEL.format("", inside), **{"small.yaml": "a: 1\n"}) == [{"model": "small"}]


def test_a_robot_may_be_off_by_default(folder: Folder) -> None:
    inside = f'<group if="$(arg real)">{DESCRIPTION}</group>'
    assert variants(folder, NEEDS_MODEL.format("", inside)) == [
        {"model": "large", "real": "true"},
        {"model": "small", "real": "true"},
    ]


def test_a_target_with_arguments_is_left_as_it_is(folder: Folder) -> None:
    folder.write({"l.launch": NEEDS_MODEL.format("", DESCRIPTION)})
    target = Target(str(folder.path / "l.launch"), (("model", "small"),))
    assert Loader(Settings()).variants(target) == [target]


def test_a_launch_file_in_python_needs_arguments_too(folder: Folder) -> None:
    text = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, ThisLaunchFileDir
from launch_ros.actions import Node

def generate_launch_description():
    file = [ThisLaunchFileDir(), '/', LaunchConfiguration('model'), '.urdf.xacro']
    node = Node(package='robot_state_publisher', executable='robot_state_publisher',
                parameters=[{'robot_description': Command(['xacro ', *file])}])
    return LaunchDescription([DeclareLaunchArgument('model'), node])
"""
    folder.write({"small.urdf.xacro": ROBOT, "l.launch.py": text})
    (target,) = Loader(Settings()).variants(Target(str(folder.path / "l.launch.py")))
    assert target.arguments == (("model", "small"),)


@pytest.mark.parametrize("default", [1, 2])
def test_of_files_chosen_by_another_argument_the_one_that_fits_the_robot_is_loaded(
    folder: Folder, default: int
) -> None:
    """The file for the small arm names no joint that the large one lacks: the one that names most fits best."""
    joint = '<joint name="{0}" type="fixed"><parent link="base"/><child link="{0}"/></joint><link name="{0}"/>'
    arms = {"small": ["a"], "large": ["a", "b"]}
    for name, joints in arms.items():
        inside = "".join(map(joint.format, joints))
        folder.write({f"{name}.urdf.xacro": f'<robot name="r"><link name="base"/>{inside}</robot>'})
        folder.write({f"{len(joints)}dof.yaml": f"arm: {{type: a/B, joints: {joints}}}\n"})
    dof = f'<arg name="dof" default="{default}"/>'
    loaded = '<rosparam file="$(dirname)/$(arg dof)dof.yaml" ns="$(arg name)"/>'
    folder.write({"l.launch": NEEDS_MODEL.format("", DESCRIPTION + dof + loaded)})
    loader = Loader(Settings())
    for target in loader.variants(Target(str(folder.path / "l.launch"))):
        controllers = loader.load(target).project.controllers
        expected = f"{len(arms[dict(target.arguments)['model']])}dof.yaml"
        assert controllers is not None
        assert [Path(file.path).name for file in controllers.files] == [expected]


@pytest.mark.parametrize(("needed", "exists"), [('<arg name="model" default=""/>', None), ("", False)])
def test_a_file_whose_name_needs_an_argument_is_not_missing(folder: Folder, needed: str, exists: bool | None) -> None:
    path = "$(dirname)/$(arg model).yaml" if needed else "$(dirname)/.yaml"
    folder.write({"l.launch": f'<launch>{needed}<rosparam file="{path}"/></launch>'})
    launch = Loader(Settings()).load(Target(str(folder.path / "l.launch"))).project.launch
    assert launch is not None
    assert [reference.file.exists for reference in launch.references] == [exists]


def test_an_empty_default_of_an_included_launch_file_is_not_a_file_name(folder: Folder) -> None:
    folder.write({"l.launch": '<launch><include file="$(dirname)/inner.launch"/></launch>'})
    inner = '<launch><arg name="model" default=""/><rosparam file="$(dirname)/$(arg model).yaml"/></launch>'
    folder.write({"inner.launch": inner})
    launch = Loader(Settings()).load(Target(str(folder.path / "l.launch"))).project.launch
    assert launch is not None
    assert {reference.use: reference.file.exists for reference in launch.references}["parameters"] is None


def test_a_guess_that_brings_no_robot_does_not_stand_beside_a_documented_start(folder: Folder) -> None:
    loading = '<launch>\n  <arg name="speed"/><rosparam file="$(dirname)/$(arg speed).yaml"/>'
    text = NEEDS_MODEL.format("", DESCRIPTION).replace("<launch>", loading)
    folder.write({"small.urdf.xacro": ROBOT, "large.urdf.xacro": ROBOT, "fast.yaml": "a: 1", "slow.yaml": "a: 1"})
    folder.write({"l.launch": text})
    told = (("speed", "slow"), ("model", "large"))
    found = Loader(Settings()).variants(Target(str(folder.path / "l.launch"), documented=((told, "README.md:1"),)))
    assert [(one.arguments, one.told_at) for one in found] == [(told, "README.md:1")]
