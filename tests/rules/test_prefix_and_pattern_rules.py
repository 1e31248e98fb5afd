"""What is told of names that do not follow the others: parts without their macro's prefix, joints unlike their
controllers."""

from __future__ import annotations

import pytest
import robots
from folder import Folder


def told(folder: Folder, name: str, text: str) -> list[str]:
    """The findings of the two rules in one file."""
    folder.write({name: text})
    return [f"{finding.code} {finding.message}" for finding in robots.findings(name, ("UC365", "UC448"))]


# -- prefixes --------------------------------------------------------------------------------------------------------

CONTROL = """
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="control" params="{params}">
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      {parts}
    </ros2_control>
  </xacro:macro>
  {call}
</robot>
"""
JOINT = '<joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>'


@pytest.mark.parametrize(
    ("params", "call", "prefix"),
    [
        ("name prefix", "", "prefix"),
        ("tf_prefix:='' name", "", "tf_prefix"),
        ("prefix:=^|left_", '<link name="base"/><xacro:control/>', "prefix"),
    ],
)
def test_a_joint_without_the_prefix_that_its_macro_takes_is_told(
    folder: Folder, params: str, call: str, prefix: str
) -> None:
    assert told(folder, "r.xacro", CONTROL.format(params=params, parts=JOINT, call=call)) == [
        f"UC365 joint 'elbow' has no prefix; its macro takes '{prefix}', but never uses it"
    ]


def test_a_joint_in_no_macro_needs_no_prefix(folder: Folder) -> None:
    folder.write({"part.xacro": f'<robot><ros2_control name="a" type="system">{JOINT}</ros2_control></robot>'})
    include = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="part.xacro"/></robot>'
    )
    assert told(folder, "r.xacro", include) == []


@pytest.mark.parametrize(
    ("params", "parts"),
    [
        ("name", JOINT),
        ("prefixes", JOINT),
        ("prefix", JOINT.replace("elbow", "${prefix}elbow")),
        ("prefix", '<sensor name="imu"><param name="frame">${prefix}imu</param></sensor>'),
        ("prefix", '<gpio name="io"><state_interface name="in"/></gpio>'),
        ("prefix", f'<xacro:macro name="inner" params="prefix">{JOINT}</xacro:macro>{JOINT}'),
    ],
    ids=["no prefix", "another word", "given", "used elsewhere", "no part of the URDF", "a macro in the macro"],
)
def test_it_is_silent_where_a_macro_has_no_prefix_or_uses_it(folder: Folder, params: str, parts: str) -> None:
    assert told(folder, "r.xacro", CONTROL.format(params=params, parts=parts, call="")) == []


# -- joints that controllers are called after ------------------------------------------------------------------------


def controllers(**joints: str) -> str:
    """Controllers of ROS 1 with their joints."""
    kind = "position_controllers/JointPositionController"
    rows = [f"{name}_position_controller: {{type: {kind}, {joint}}}" for name, joint in joints.items()]
    return "\n".join(rows)


ROW = {name: f"joint: {name}_joint" for name in ("shoulder_pan", "elbow_flex", "wrist_roll")}


def test_half_a_controllers_name_is_no_joints(folder: Folder) -> None:
    [said] = told(folder, "c.yaml", controllers(**ROW, forearm_roll="joint: forearm_roll_position"))
    assert said == (
        "UC448 joint 'forearm_roll_position' does not match the name of its controller "
        "'forearm_roll_position_controller', unlike the other joints; did you mean 'forearm_roll_joint'?"
    )


@pytest.mark.parametrize(
    "more",
    [
        {"forearm": "joint: forearm"},
        {"l_wheel": "joint: r_wheel_joint"},
        {"gripper": "joints: [left_finger, right_finger]"},
        {"gripper": "joints: $(var joints)"},
        {"gripper": "width: 1"},
        {"a": "joint: a_link", "b": "joint: b_link", "c": "joint: c_link"},
    ],
)
def test_other_names_of_joints_are_let_be(folder: Folder, more: dict[str, str]) -> None:
    assert told(folder, "c.yaml", controllers(**ROW, **more)) == []


def test_two_controllers_show_no_pattern(folder: Folder) -> None:
    rows = dict(list(ROW.items())[:2])
    assert told(folder, "c.yaml", controllers(**rows, elbow="joint: elbo_joint")) == []
