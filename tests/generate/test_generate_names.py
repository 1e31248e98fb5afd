"""Files for joints of any name, number and interface: each reader reads back what was meant."""

from __future__ import annotations

import ast
import re
import xml.etree.ElementTree as ET

import pytest
import yaml
from folder import Folder
from generating import command, made, read
from hypothesis import given, settings
from hypothesis import strategies as st
from sampling import examples

from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.facts import JointFacts, RobotFacts

XML = st.characters(exclude_categories=("Cs", "Cc"), exclude_characters="\ufffe\uffff")
NAMES = st.one_of(
    st.text(XML, min_size=1, max_size=12),
    st.sampled_from(
        ("on", "off", "1e3", "~", "null", "yes", "0x1F", "1_000", "1:30", "=", "<<", "- a", "? b", "a: b", "#c")
    ),
    st.sampled_from(
        ("${x}", "$(arg y)", "$${z}", "a--b", '"', "'", "<b>", "&amp;", "größe", "関節", "a b", " ", "\\", "%")
    ),
)
JOINTS = st.lists(NAMES, min_size=1, max_size=8, unique=True)
INTERFACES = st.sampled_from(("position", "velocity", "effort"))


def joints_of(names: list[str]) -> tuple[JointFacts, ...]:
    return tuple(JointFacts(name, lower=-1.0, upper=1.0, effort=5.0, velocity=2.0) for name in names)


def expanded(text: str) -> str:
    """A text without expressions as xacro leaves it: of several dollars before a bracket it takes one."""
    return re.sub(r"\$(\$+[{(])", r"\1", text)


@settings(max_examples=examples(15))
@given(JOINTS, INTERFACES)
def test_a_ros2_control_tag_names_the_joints(names: list[str], interface: str) -> None:
    [file] = made(
        "gen-ros2-control", GeneratorOptions("jazzy", interfaces=(interface,)), joints_of(names), RobotFacts()
    )
    parts = ET.fromstring(file.text.encode()).findall("ros2_control/joint")
    assert [expanded(part.get("name", "")) for part in parts] == names
    assert {one.get("name") for part in parts for one in part.findall("command_interface")} == {interface}


@settings(max_examples=examples(15))
@given(JOINTS, INTERFACES, st.booleans())
def test_transmissions_name_the_joints(names: list[str], interface: str, macro: bool) -> None:
    options = GeneratorOptions("noetic", interfaces=(interface,), macro=macro)
    [file] = made("gen-transmissions", options, joints_of(names), RobotFacts())
    root = ET.fromstring(file.text.encode())
    call = "{http://www.ros.org/wiki/xacro}joint_transmission"
    found = (
        [one.get("joint", "") for one in root.findall(call)]
        if macro
        else [one.get("name", "") for one in root.findall("transmission/joint")]
    )
    assert [expanded(name) for name in found] == names


@settings(max_examples=examples(15))
@given(JOINTS, INTERFACES, st.sampled_from(("humble", "jazzy", "rolling")))
def test_a_trajectory_controller_names_the_joints(names: list[str], interface: str, distro: str) -> None:
    options = GeneratorOptions(distro, types=("trajectory",), interfaces=(interface,))
    [file] = made("gen-controllers", options, joints_of(names), RobotFacts())
    of_arm = read(file.text)["joint_trajectory_controller"]["ros__parameters"]
    assert of_arm["joints"] == names
    assert of_arm["command_interfaces"] == [interface]


@settings(max_examples=examples(15))
@given(st.text(XML, min_size=1, max_size=20), st.sampled_from(("python", "xml", "yaml")))
def test_a_launch_file_can_be_read_whatever_the_robot_is_called(name: str, form: str) -> None:
    options = GeneratorOptions("jazzy", "gz", ("effort",), form=form, package="p", command=f"urdfctl gen-launch {name}")
    [file] = made("gen-launch", options, joints_of(["a"]), RobotFacts(name))
    readers = {"python": ast.parse, "yaml": yaml.safe_load, "xml": lambda text: ET.fromstring(text.encode())}
    assert readers[form](file.text) is not None


@pytest.mark.parametrize("count", [1, 7, 200])
@pytest.mark.parametrize("distro", ["noetic", "jazzy"])
def test_a_package_is_for_all_joints(count: int, distro: str) -> None:
    names = [f"joint_{number}" for number in range(count)]
    options = GeneratorOptions(distro, types=("effort",), package="p")
    texts = {file.name: file.text for file in made("gen-all", options, joints_of(names), RobotFacts("r"))}
    root = ET.fromstring(texts["urdf/control.xacro"].encode())
    path = "transmission/joint" if distro == "noetic" else "ros2_control/joint"
    assert [one.get("name") for one in root.findall(path)] == names
    assert texts["config/controllers.yaml"].count("\n") > count


def test_files_are_the_same_in_processes_that_hash_otherwise(folder: Folder) -> None:
    words = ("gen-all", "-", "--type", "trajectory", "--interface", "effort", "--distro", "noetic", "-o")
    for seed in ("1", "2"):
        ran = folder.run(
            *words, seed, "--package", "p", text="wrist\nelbow\nshoulder\n", environ={"PYTHONHASHSEED": seed}
        )
        assert ran.returncode == 0
        assert "next: roslaunch p control.launch\n" in ran.stderr
    assert command(*words, "1", "--package", "p", "--check", text="wrist\nelbow\nshoulder\n").returncode == 0
    for path in (folder.path / "1").rglob("*.*"):
        assert path.read_bytes() == (folder.path / "2" / path.relative_to(folder.path / "1")).read_bytes()
