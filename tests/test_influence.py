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
