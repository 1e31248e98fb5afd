"""A tag that makes a Python object is told wherever YAML is read, and nothing is made of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from folder import Folder
from robots import findings

from urdfctl.errors import UserError
from urdfctl.load.target import Target
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import SourceText
from urdfctl.source.yaml.tree import read_yaml

TAG = "!!python/object/apply:os.system"
LINK = '<robot name="r">{}<link name="base"/></robot>'
TYPED = "c:\n  type: effort_controllers/JointEffortController\n  joint: j\n"
ROS1 = (
    '<launch><param name="robot_description" textfile="$(find p)/r.urdf"/>{}'
    '<node pkg="controller_manager" type="spawner" name="s" args="c"/></launch>'
)
TRANSMISSION = '<transmission name="t"><type>transmission_interface/SimpleTransmission</type></transmission>'
PYTHON = """import os, yaml
from launch import LaunchDescription
from launch_ros.actions import Node
from ament_index_python.packages import get_package_share_directory

def generate_launch_description():
    with open(os.path.join(get_package_share_directory('p'), 'x.yaml')) as file:
        content = yaml.safe_load(file)
    return LaunchDescription([Node(package='controller_manager', executable='ros2_control_node', parameters=[content])])
"""
DEMO = """from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_demo_launch

def generate_launch_description():
    return generate_demo_launch(MoveItConfigsBuilder('r', package_name='p').to_moveit_configs())
"""
SETUP = "moveit_setup_assistant_config:\n  URDF: {package: p, relative_path: r.urdf}\n"
MOVEIT = {
    "r.urdf": LINK.format(""),
    "d.launch.py": DEMO,
    "config/r.srdf": '<robot name="r"/>',
    ".setup_assistant": SETUP,
}

READ: dict[str, tuple[dict[str, str], str, str]] = {
    "a controller file of ROS 2": (
        {"c.yaml": "controller_manager:\n  ros__parameters:\n    update_rate: 100\n    x: @\n"},
        "c.yaml",
        "warning c.yaml",
    ),
    "a controller file of ROS 1": ({"c.yaml": f"{TYPED}  x: @\n"}, "c.yaml", "error c.yaml"),
    "a file that roslaunch loads": (
        {
            "r.urdf": LINK.format(TRANSMISSION),
            "c.yaml": f"{TYPED}  x: @\n",
            "a.launch": ROS1.format('<rosparam file="$(find p)/c.yaml"/>'),
        },
        "a.launch",
        "error c.yaml",
    ),
    "parameters in a launch file": (
        {"r.urdf": LINK.format(TRANSMISSION), "a.launch": ROS1.format(f"<rosparam>\n{TYPED}  x: @\n</rosparam>")},
        "a.launch",
        "error a.launch",
    ),
    "a launch file": (
        {"a.launch.yaml": "launch:\n- node: {pkg: controller_manager, exec: spawner, args: c, name: @}\n"},
        "a.launch.yaml",
        "error a.launch.yaml",
    ),
    "a file that a launch file in Python loads": (
        {"a.launch.py": PYTHON, "x.yaml": "a: @\n"},
        "a.launch.py",
        "error x.yaml",
    ),
    ".setup_assistant": ({**MOVEIT, ".setup_assistant": f"{SETUP}  x: @\n"}, "d.launch.py", "error .setup_assistant"),
    "MoveIt's kinematics": (
        {**MOVEIT, "config/kinematics.yaml": "g: {kinematics_solver: k, x: @}\n"},
        "d.launch.py",
        "error kinematics.yaml",
    ),
    "MoveIt's limits": (
        {**MOVEIT, "config/joint_limits.yaml": "joint_limits: {j: {x: @}}\n"},
        "d.launch.py",
        "error joint_limits.yaml",
    ),
    "MoveIt's controllers": (
        {**MOVEIT, "config/moveit_controllers.yaml": "moveit_simple_controller_manager: {x: @, controller_names: []}"},
        "d.launch.py",
        "error moveit_controllers.yaml",
    ),
    "MoveIt's pipeline": (
        {**MOVEIT, "config/ompl_planning.yaml": "planning_plugin: @\n"},
        "d.launch.py",
        "error ompl_planning.yaml",
    ),
    "a file that an expression loads": (
        {
            "r.xacro": LINK.format("<a b=\"${xacro.load_yaml('x.yaml')}\"/>").replace(
                'name="r"', 'name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"'
            ),
            "x.yaml": "a: @\n",
        },
        "r.xacro",
        "error r.xacro",
    ),
}  # fmt: skip


def told(folder: Folder, files: dict[str, str], path: str, value: str) -> list[str]:
    folder.write({"package.xml": "<package format='3'><name>p</name></package>"})
    folder.write({name: text.replace("@", value) for name, text in files.items()})
    found = findings(Target(str(folder.path / path)), ("UC010", "UC032"), workspace=str(folder.path))
    return [f"{one.severity.value} {Path(one.at.file).name}" for one in found]


@pytest.mark.parametrize("name", READ)
def test_the_tag_is_told_and_nothing_runs(name: str, folder: Folder) -> None:
    files, path, expected = READ[name]
    marker = folder.path / "marker"
    assert told(folder, files, path, f"{TAG} ['touch {marker}']") == [expected]
    assert told(folder, files, path, "!!str a") == []
    assert not marker.exists()


def test_the_tag_in_a_file_of_tasks_is_an_error(tmp_path: Path) -> None:
    from urdfctl.smoke.tasks.task_file import read_tasks

    (tmp_path / "t.yaml").write_text(f"controllers:\n  c: {{position: {{j: 0.1}}}}\nstart: {TAG} ['true']\n")
    with pytest.raises(UserError, match=r"t\.yaml:3: '!!python/object/apply:os\.system' makes a Python object"):
        read_tasks(str(tmp_path / "t.yaml"))


def test_the_tag_in_a_list_of_joints_is_an_error() -> None:
    from urdfctl.generate.request.joint_list import joints_listed

    with pytest.raises(UserError, match="could not determine a constructor for the tag"):
        joints_listed(f"- {TAG} ['true']\n", "j.yaml")


def test_a_definition_with_the_tag_is_none() -> None:
    from urdfctl.catalog.definitions import definition_of

    text = "n:\n  a: {type: int, default_value: @}\n"
    sound, tagged = (
        read_yaml(SourceText("/n.yaml", text.replace("@", value).encode())) for value in ("1", f"{TAG} []")
    )
    assert definition_of(sound) is not None
    assert definition_of(tagged) is None


def test_a_tag_is_known_by_what_it_means_not_by_how_it_is_written() -> None:
    text = "%TAG !p! tag:yaml.org,2002:python/\n---\n- !p!tuple [1]\n- !x 1\n"
    text += "- !<tag:yaml.org,2002:python/name:os.system> ''\n"
    found: list[Problem] = read_yaml(SourceText("/a.yaml", text.encode())).refused_tags
    assert {problem.kind for problem in found} == {ProblemKind.PYTHON_TAG}
    assert [problem.subject for problem in found] == ["!p!tuple", "!<tag:yaml.org,2002:python/name:os.system>"]
