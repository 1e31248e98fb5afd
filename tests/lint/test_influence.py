"""A finding tells which YAML file a value came from, and which argument chose that file."""

from __future__ import annotations

import pytest
from folder import Folder

LIMITS = "joints:\n  elbow: {lower: 1.0, upper: -1.0}\n"
ROBOT = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="model" default="big"/>
  <xacro:arg name="limits" default="config/$(arg model)/limits.yaml"/>
  <xacro:macro name="arm" params="limits_file">
    <xacro:property name="limits" value="${xacro.load_yaml(limits_file)['joints']}"/>
    <xacro:property name="elbow" value="${limits['elbow']}"/>
    <link name="upper"/>
    <link name="fore"/>
    <joint name="elbow" type="revolute">
      <parent link="upper"/>
      <child link="fore"/>
      <limit lower="LOWER" upper="UPPER" effort="1" velocity="1"/>
    </joint>
  </xacro:macro>
  <xacro:arm limits_file="$(arg limits)"/>
</robot>
"""
FROM_YAML = {"LOWER": "${elbow['lower']}", "UPPER": "${elbow['upper']}"}


@pytest.fixture
def arm(folder: Folder) -> Folder:
    folder.write({"config/big/limits.yaml": LIMITS, "config/small/limits.yaml": LIMITS})
    return folder


def notes(folder: Folder, texts: dict[str, str], *words: str) -> list[str]:
    robot = ROBOT
    for name, text in texts.items():
        robot = robot.replace(name, text)
    folder.write({"robot.xacro": robot})
    lines = folder.run("lint", "robot.xacro", "--select", "UC124,UC125,UC126,UC127", *words).stdout.splitlines()
    return [line.strip() for line in lines if "the value comes from" in line]


def test_a_value_from_yaml_is_told_with_its_file_and_the_argument_that_chose_it(arm: Folder) -> None:
    said = "note: the value comes from 'config/{}/limits.yaml', chosen by the argument 'model'"
    assert notes(arm, FROM_YAML)[:1] == [said.format("big")]
    assert notes(arm, FROM_YAML, "model:=small")[:1] == [said.format("small")]


def test_an_argument_that_names_the_file_itself_is_the_one_that_chose_it(arm: Folder) -> None:
    [said, *_] = notes(arm, FROM_YAML, "limits:=config/small/limits.yaml")
    assert said == "note: the value comes from 'config/small/limits.yaml', chosen by the argument 'limits'"


def test_a_value_that_stands_in_the_description_comes_from_no_file(arm: Folder) -> None:
    assert notes(arm, {"LOWER": "${1.0}", "UPPER": "-1"}) == []


def told_of_arguments(folder: Folder, body: str, *words: str) -> list[str]:
    folder.write({"robot.xacro": f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{body}\n</robot>\n'})
    lines = folder.run("lint", "robot.xacro", "--select", "UC028", "--format", "concise", *words).stdout.splitlines()
    return [line.partition(" is empty by default")[0].partition("UC028 ")[2] for line in lines if "UC028" in line]


def test_an_argument_that_is_empty_by_default_and_names_a_file_to_load_is_told(arm: Folder) -> None:
    through_a_macro = """<xacro:arg name="file" default=" "/><xacro:arg name="side" default=""/>
        <xacro:macro name="arm" params="path">
          <xacro:property name="limits" value="${xacro.load_yaml(path)}"/>
          <link name="${limits['joints']['elbow']['lower']}$(arg side)"/>
        </xacro:macro>
        <xacro:arm path="$(arg file)"/>"""
    assert told_of_arguments(arm, through_a_macro) == []  # it only needs arguments
    assert told_of_arguments(arm, through_a_macro, "side:=left") == ["argument 'file'"]
    assert told_of_arguments(arm, through_a_macro, "file:=config/big/limits.yaml") == []


def test_an_argument_in_the_path_of_an_include_is_told(arm: Folder) -> None:
    included = """<xacro:arg name="tool" default=""/><xacro:include filename="tools/$(arg tool).xacro"/>
        <link name="$(arg side)"/>"""
    assert told_of_arguments(arm, included) == []  # it only needs arguments
    assert told_of_arguments(arm, included, "side:=left") == ["argument 'tool'"]
    assert told_of_arguments(arm, included.replace(' default=""', ""), "side:=left") == []
    assert told_of_arguments(arm, included.replace('default=""', 'default="claw"'), "side:=left") == []


def test_an_argument_is_not_told_where_something_else_may_be_to_blame(arm: Folder) -> None:
    two = """<xacro:arg name="file" default=""/>
        <link name="${load_yaml('config/none.yaml')['a']}${load_yaml('$(arg file)')['a']}"/>"""
    assert told_of_arguments(arm, two) == []
    together = """<xacro:arg name="file" default=""/><xacro:property name="f" value="$(arg file)"/>
        <link name="${load_yaml(f)[load_yaml('config/none.yaml')]}"/>"""
    assert told_of_arguments(arm, together) == []


def test_an_include_that_need_not_be_there_may_be_named_by_an_empty_argument(arm: Folder) -> None:
    body = '<xacro:arg name="tool" default=""/><xacro:include filename="$(arg tool)" optional="true"/><link name="a"/>'
    assert told_of_arguments(arm, body) == []
    assert arm.run("lint", "robot.xacro").returncode == 0
