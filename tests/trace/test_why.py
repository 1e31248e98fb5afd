"""`urdfctl why` leads from a value to what it was evaluated from, and from a line to what depends on it."""

from __future__ import annotations

import json
from typing import Any

import pytest
from folder import Folder

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
ROBOT = f"""\
<robot name="r" {XACRO}>
  <xacro:arg name="speed" default="2.0"/>
  <xacro:arg name="fast" default="true"/>
  <xacro:property name="limits" value="${{xacro.load_yaml('limits.yaml')['elbow']}}"/>
  <xacro:property name="scale" value="0.5"/>
  <xacro:macro name="arm" params="prefix length:=0.3 effort:=^|9">
    <link name="${{prefix}}upper"/>
    <link name="${{prefix}}fore"/>
    <joint name="${{prefix}}elbow" type="revolute">
      <parent link="${{prefix}}upper"/>
      <child link="${{prefix}}fore"/>
      <origin xyz="${{length}} 0 ${{max(length, 7)}}"/>
      <limit lower="${{limits['lower']}}" upper="1" effort="${{effort}}" velocity="${{scale * $(arg speed)}}"/>
      <xacro:if value="${{len(prefix) > 0}}">
        <dynamics damping="0.7"/>
      </xacro:if>
    </joint>
  </xacro:macro>
  <xacro:arm prefix="left_"/>
</robot>
"""
FILES = {"robot.xacro": ROBOT, "limits.yaml": "elbow:\n  lower: -1.25\n  upper: 2.0\n"}


@pytest.fixture
def arm(folder: Folder) -> Folder:
    folder.write(FILES)
    return folder


def answers(folder: Folder, *words: str) -> list[dict[str, Any]]:
    ran = folder.run("why", *words, "--format", "json")
    assert ran.returncode == 0, ran.stderr
    return list(json.loads(ran.stdout)["values"])


def answer(folder: Folder, address: str, *words: str) -> dict[str, Any]:
    [found] = answers(folder, "robot.xacro", f"joint:left_elbow/{address}", *words)
    return found


def steps(found: dict[str, Any]) -> list[str]:
    return [f"{link['kind']} {link['name']} = {link['value']}".replace(" =", " =", 1) for link in found["chain"]]


def numbers(found: dict[str, Any]) -> list[tuple[str, int]]:
    return [(number["text"], number["line"]) for number in found["numbers"]]


def test_a_value_comes_from_its_expression_the_property_and_the_argument(arm: Folder) -> None:
    found = answer(arm, "limit/@velocity")
    assert found["value"] == "1.0"
    assert steps(found) == ["attribute velocity = 1.0", "property scale = 0.5", "argument speed = 2.0"]
    assert [link.get("line") for link in found["chain"]] == [13, 5, 2]
    assert numbers(found) == [("0.5", 5), ("2.0", 2)]
    assert found["chain"][2]["given_by"] == "default"


def test_an_argument_that_is_given_has_no_place(arm: Folder) -> None:
    found = answer(arm, "limit/@velocity", "speed:=3")
    assert (found["value"], numbers(found)) == ("1.5", [("0.5", 5)])
    given = found["chain"][2]
    assert (given["name"], given["value"], given["given_by"], "file" in given) == ("speed", "3", "command line", False)


def test_a_value_from_yaml_leads_to_its_key_and_names_the_calls_on_the_way(arm: Folder) -> None:
    found = answer(arm, "limit/@lower")
    assert [(link["kind"], link["name"]) for link in found["chain"]] == [
        ("attribute", "lower"), ("property", "limits"), ("yaml", ""), ("yaml", "elbow.lower"),
    ]  # fmt: skip
    assert [(call["name"], call["line"]) for call in found["chain"][0]["calls"]] == [("arm", 19)]
    assert numbers(found) == [("1.25", 2)]


def test_defaults_of_parameters_are_found_in_the_params_of_the_macro(arm: Folder) -> None:
    assert numbers(answer(arm, "origin/@xyz")) == [("0", 12), ("7", 12), ("0.3", 6)]
    assert numbers(answer(arm, "limit/@effort")) == [("9", 6)]


def test_a_forwarded_parameter_leads_to_the_property_around_the_call(arm: Folder) -> None:
    arm.write({"robot.xacro": ROBOT.replace("<xacro:arm ", '<xacro:property name="effort" value="4"/><xacro:arm ')})
    assert numbers(answer(arm, "limit/@effort")) == [("4", 19)]


def test_a_number_that_does_not_change_the_value_is_not_listed(arm: Folder) -> None:
    arm.write({"robot.xacro": ROBOT.replace("${effort}", "${min(effort, 100) if xacro.arg('fast') == 'true' else 3}")})
    assert numbers(answer(arm, "limit/@effort")) == [("9", 6)]
    assert numbers(answer(arm, "limit/@effort", "fast:=false")) == [("3", 13)]


def test_the_definition_that_was_in_scope_is_the_one(arm: Folder) -> None:
    again = '<xacro:property name="scale" value="${scale * 3}" lazy_eval="false"/>\n  <xacro:arm '
    arm.write({"robot.xacro": ROBOT.replace("<xacro:arm ", again)})
    found = answer(arm, "limit/@velocity")
    assert found["value"] == "3.0"
    assert numbers(found) == [("3", 19), ("2.0", 2), ("0.5", 5)]


def test_a_condition_around_a_part_decides_whether_it_is_there(arm: Folder) -> None:
    [decided] = answer(arm, "dynamics/@damping")["decided_by"]
    assert (decided["text"], decided["line"]) == ("${len(prefix) > 0}", 14)


def test_an_attribute_of_xacro_and_a_block_lead_to_where_they_are_written(folder: Folder) -> None:
    body = """<xacro:macro name="m" params="*b"><link name="a"><xacro:insert_block name="b"/></link></xacro:macro>
        <xacro:property name="m" value="3"/>
        <xacro:m><inertial><mass><xacro:attribute name="value" value="${m + 1}.5"/></mass></inertial></xacro:m>"""
    folder.write({"robot.xacro": f'<robot name="r" {XACRO}>\n{body}\n<link name="b"/></robot>'})
    [found] = answers(folder, "robot.xacro", "link:a/inertial/mass/@value")
    assert (found["value"], numbers(found)) == ("4.5", [("1", 4), (".5", 4), ("3", 3)])


def test_an_argument_that_nobody_gives_is_named_as_the_reason_for_an_unknown_value(arm: Folder) -> None:
    arm.write({"robot.xacro": ROBOT.replace(' name="speed" default="2.0"', ' name="other" default="2.0"')})
    found = answer(arm, "limit/@velocity")
    assert found["value"] == "?"
    assert {link["name"]: link["given_by"] for link in found["chain"]}["speed"] == "not given"


def test_a_file_that_only_some_arguments_choose_asks_for_them(arm: Folder) -> None:
    arm.write({"other.yaml": "elbow: {lower: 1}\n"})
    said = "no robot reads 'other.yaml'; name the robot, and the arguments with which it does: "
    assert arm.run("why", "other.yaml:1").stderr == f"urdfctl: {said}urdfctl why robot.xacro other.yaml:1 NAME:=VALUE\n"


def test_a_description_without_the_prefix_of_xacro_is_traced_too(folder: Folder) -> None:
    body = '<macro name="m" params="v"><link name="a"><inertial><mass value="${2 * v}"/></inertial></link></macro>'
    folder.write({"robot.xacro": f'<robot name="r" {XACRO}>\n{body}\n<m v="1.5"/><link name="b"/></robot>'})
    [found] = answers(folder, "robot.xacro", "link:a/inertial/mass/@value")
    assert (found["value"], numbers(found)) == ("3.0", [("2", 2), ("1.5", 3)])


def test_a_plain_urdf_leads_to_itself(folder: Folder) -> None:
    folder.write(
        {"r.urdf": '<robot name="r">\n<link name="a"><inertial><mass value="2.5"/></inertial></link>\n</robot>'}
    )
    [found] = answers(folder, "r.urdf", "link:a/inertial/mass/@value")
    assert numbers(found) == [("2.5", 2)]


def test_a_line_leads_to_the_values_that_depend_on_it(arm: Folder) -> None:
    assert [found["address"] for found in answers(arm, "limits.yaml:2")] == ["joint:left_elbow/limit/@lower"]
    assert [found["address"] for found in answers(arm, "robot.xacro", "robot.xacro:5")] == [
        "joint:left_elbow/limit/@velocity"
    ]
    assert [found["address"] for found in answers(arm, "robot.xacro:6:50")] == ["joint:left_elbow/origin/@xyz"]


CONTROL = """<ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
  <joint name="left_elbow"><command_interface name="position"/><state_interface name="position"/></joint>
</ros2_control>"""
CONTROLLERS = """\
controller_manager: {ros__parameters: {arm: {type: joint_trajectory_controller/JointTrajectoryController}}}
arm:
  ros__parameters:
    joints: [left_elbow]
    command_interfaces: [position]
    state_interfaces: [position]
"""
LAUNCH = """\
<launch>
  <let name="d" value="$(command 'xacro $(dirname)/robot.xacro speed:=4')"/>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param name="robot_description" value="$(command 'xacro $(dirname)/robot.xacro speed:=4')"/>
    <param from="$(dirname)/controllers.yaml"/>
  </node>
  <node pkg="controller_manager" exec="spawner" args="arm"/>
</launch>
"""


def test_what_uses_the_joint_is_named_and_a_launch_file_gives_arguments(arm: Folder) -> None:
    arm.write({"robot.xacro": ROBOT.replace("</robot>", f"{CONTROL}</robot>"), "controllers.yaml": CONTROLLERS})
    arm.write({"bringup.launch.xml": LAUNCH})
    [found] = answers(arm, "bringup.launch.xml", "joint:left_elbow/limit/@velocity")
    uses = {(use["kind"], use["name"], use["how"]) for use in found["used_by"]}
    assert {("controller", "arm", "command interface position"), ("hardware", "hw", "ros2_control")} <= uses
    given = found["chain"][-1]
    assert (found["value"], given["given_by"], given["file"].rpartition("/")[2]) == (
        "2.0",
        "launch file",
        "bringup.launch.xml",
    )


def test_the_text_shows_the_chain(arm: Folder) -> None:
    shown = arm.run("why", "robot.xacro", "joint:left_elbow/limit/@velocity").stdout.splitlines()
    assert shown == [
        "joint:left_elbow/limit/@velocity = 1.0",
        "  robot.xacro:13:80: attribute velocity = ${scale * $(arg speed)} → 1.0",
        "    in macro arm, at robot.xacro:19:3",
        "    robot.xacro:5:39: property scale = 0.5",
        "    robot.xacro:2:36: argument speed = 2.0, default",
        "  numbers that it depends on: 0.5 (robot.xacro:5:39), 2.0 (robot.xacro:2:36)",
    ]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("joint:left_elbo/limit/@lower",), "joint 'left_elbo' does not exist; did you mean 'left_elbow'?"),
        (("joint:left_elbow/limits/@lower",), "joint 'left_elbow' has no <limits>; did you mean 'limit'?"),
        (
            ("joint:left_elbow/limit/@lowr",),
            "<limit> of joint 'left_elbow' has no attribute 'lowr'; did you mean 'lower'?",
        ),
        (("elbow",), "'elbow' names no part of the robot; write joint:NAME/limit/@velocity, or FILE:LINE"),
        (("robot.xacro:99",), "'robot.xacro' has 20 lines, not 99"),
        (("robot.xacro:18",), "no value of the robot depends on robot.xacro:18"),
        ((), "why needs a value: urdfctl why robot.xacro VALUE; write joint:NAME/limit/@velocity, or FILE:LINE"),
    ],
)
def test_a_question_without_an_answer_gets_one_line(arm: Folder, words: tuple[str, ...], said: str) -> None:
    ran = arm.run("why", "robot.xacro", *words)
    assert (ran.returncode, ran.stderr.replace(f"{arm.path}/", "")) == (2, f"urdfctl: {said}\n")
