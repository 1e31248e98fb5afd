"""The rules on MoveIt's configuration of the controllers: moveit_controllers.yaml beside ros2_controllers.yaml."""

from __future__ import annotations

import re
from textwrap import dedent

import pytest
import robots
from folder import Folder

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.rules.moveit.samples import CONTROLLERS, configured

SECTION = """arm_controller:
        type: FollowJointTrajectory
        action_ns: follow_joint_trajectory
        default: true
        joints: [shoulder, elbow]"""


def found(folder: Folder, old: str = "", new: str = "", controllers: str = CONTROLLERS) -> list[tuple[str, str, str]]:
    """Return code, severity and message of the findings after `old` is replaced by `new`."""
    files = {**configured(old, new), "ros2_controllers.yaml": controllers}
    folder.write({name: dedent(text) for name, text in files.items()})
    findings = robots.findings("ros2_controllers.yaml", ("UC65",))
    return [(finding.code, finding.severity.value, finding.message) for finding in findings]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (SECTION, "", "controller_names lists 'arm_controller', but this file does not describe it"),
        ("default: true", "default: false", None),
        ("type: FollowJointTrajectory", "", "MoveIt ignores controller 'arm_controller': 'type' is missing"),
        ("joints: [shoulder, elbow]", "", "MoveIt ignores controller 'arm_controller': 'joints' is missing"),
        (
            SECTION,
            "arm_controller: 1",
            "MoveIt ignores controller 'arm_controller': 'type', 'action_ns' and 'joints' are missing",
        ),
    ],
)
def test_moveit_needs_a_type_an_action_and_joints(folder: Folder, old: str, new: str, message: str | None) -> None:
    told = [one[2] for one in found(folder, old, new)]
    assert [one[: len(message or "")] for one in told] == ([message] if message else [])


def test_the_action_that_the_setup_assistant_leaves_out_is_added(folder: Folder) -> None:
    assert found(folder, "action_ns: follow_joint_trajectory", "") == [
        ("UC651", "error", "MoveIt ignores controller 'arm_controller': 'action_ns' is missing"),
    ]
    fix = robots.findings("ros2_controllers.yaml", ("UC651",))[0].fix
    assert fix is not None
    assert [edit.text for edit in fix.edits] == ["action_ns: follow_joint_trajectory\n    "]


def test_a_name_that_no_file_declares_is_told(folder: Folder) -> None:
    incomplete, unknown = found(folder, "controller_names: [arm_controller]", "controller_names: [hand]")
    assert incomplete == ("UC651", "error", "controller_names lists 'hand', but this file does not describe it")
    declared = "declared: 'joint_state_broadcaster' and 'arm_controller'"
    message = f"MoveIt uses controller 'hand', which no file declares; {declared}"
    assert unknown == ("UC652", "warning", message)
    nothing = "other: {ros__parameters: {x: 1}}"
    assert [one[0] for one in found(folder, "[arm_controller]", "[hand]", nothing)] == ["UC651"]


def test_joints_that_are_left_out_are_told_where_partial_goals_are_refused(folder: Folder) -> None:
    message = (
        "MoveIt's joints for controller 'arm_controller' do not include 'elbow'; "
        "the controller rejects incomplete trajectories"
    )
    assert found(folder, "joints: [shoulder, elbow]", "joints: [shoulder]") == [("UC653", "warning", message)]
    partial = CONTROLLERS + "        allow_partial_joints_goal: true\n"
    assert found(folder, "joints: [shoulder, elbow]", "joints: [shoulder]", partial) == []
    gripper = found(folder, "type: FollowJointTrajectory", "type: GripperCommand")
    assert gripper == []


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "moveit_simple_controller_manager: 1",
        "moveit_simple_controller_manager: {controller_names: x}",
        "a: [",
    ],
)
def test_what_is_no_configuration_of_moveit_says_nothing(folder: Folder, text: str) -> None:
    folder.write({"ros2_controllers.yaml": dedent(CONTROLLERS), "moveit_controllers.yaml": text})
    assert robots.findings("ros2_controllers.yaml", ("UC65",)) == []


def test_a_configuration_outside_of_the_workspace_is_not_read(folder: Folder) -> None:
    folder.write({"outside.yaml": "a: 1", "in/ros2_controllers.yaml": dedent(CONTROLLERS)})
    (folder.path / "in/moveit_controllers.yaml").symlink_to(folder.path / "outside.yaml")
    settings = Settings(workspace=str(folder.path / "in"))
    linted = lint_target(Loader(settings), Target("in/ros2_controllers.yaml"), Selection()).result
    assert [path.rpartition("/")[2] for path in linted.files] == ["ros2_controllers.yaml"]


# -- ROS 1 ------------------------------------------------------------------------------------------------------------

GRIPPER = """\
<robot name="r">
  <link name="base"/><link name="left"/><link name="right"/>
  <joint name="l_gripper_finger_joint" type="continuous"><parent link="base"/><child link="left"/></joint>
  <joint name="r_gripper_finger_joint" type="continuous"><parent link="base"/><child link="right"/></joint>
</robot>
"""
DEMO = """\
<launch>
  <param name="robot_description" textfile="$(find arm)/gripper.urdf"/>
  <group ns="robot_description_planning">
    <rosparam command="load" file="$(find arm)/joint_limits.yaml"/>
  </group>
  <group ns="move_group">
    <rosparam command="load" file="$(find arm)/fake_controllers.yaml"/>
  </group>
</launch>
"""


def told_by_demo(folder: Folder, lists: str = "", limits: str = "") -> list[str]:
    manifest = '<package format="2"><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>'
    folder.write({"package.xml": manifest, "gripper.urdf": GRIPPER, "demo.launch": DEMO})
    folder.write({"fake_controllers.yaml": lists, "joint_limits.yaml": limits})
    return [finding.message for finding in robots.findings("demo.launch", ("UC654",))]


def test_joints_that_a_list_for_moveit_misspells_are_told(folder: Folder) -> None:
    lists = "controller_list: [{name: hand, joints: [l_gripper_joint, r_gripper_joint]}]"
    absent = "but the robot does not have it; did you mean"
    assert told_by_demo(folder, lists) == [
        f"joint 'l_gripper_joint' is listed for 'hand', {absent} 'l_gripper_finger_joint'?",
        f"joint 'r_gripper_joint' is listed for 'hand', {absent} 'r_gripper_finger_joint'?",
    ]
    limits = "joint_limits: {l_gripper_joint: {max_velocity: 1}, tool: {max_velocity: 1}}"
    assert told_by_demo(folder, "", limits) == [
        f"joint 'l_gripper_joint' has limits for MoveIt, {absent} 'l_gripper_finger_joint'?"
    ]


@pytest.mark.parametrize(
    "lists",
    [
        "controller_list: [{name: hand, joints: [l_gripper_finger_joint]}, {name: tool, joints: [drill]}]",
        "controller_list: [{name: hand, joints: ['$(arg side)_gripper_finger_joint', l_gripper_finger_joint]}]",
        "controller_list: [{joints: 1}, 2]",
        "controller_list: x",
        "[controller_list]",
        "",
    ],
)
def test_lists_for_moveit_that_fit_the_robot_or_are_of_other_parts_say_nothing(folder: Folder, lists: str) -> None:
    assert told_by_demo(folder, lists) == []


def test_the_limits_that_controllers_of_ros_1_are_given_are_none_of_moveits(folder: Folder) -> None:
    folder.write({"gripper.urdf": GRIPPER, "limits.yaml": "joint_limits: {l_gripper_joint: {max_velocity: 1}}"})
    assert robots.findings(Target("gripper.urdf", controllers=("limits.yaml",)), ("UC654",)) == []


@pytest.mark.parametrize(
    ("listed", "told"),
    [
        ("$(arg side)/finger", []),
        ("$(arg side)/thumb", ["left/thumb", "right/thumb"]),
        ("left/finger", ["left/finger"]),
        ("$(env SIDE)/thumb", []),
    ],
)
def test_a_list_for_moveit_is_compared_with_the_controller_of_its_namespace_as_roslaunch_evaluates_it(
    folder: Folder, listed: str, told: list[str]
) -> None:
    hand = """
        <include file="$(find arm)/hand.launch"><arg name="side" value="{0}"/></include>
        <rosparam ns="{0}" file="$(find arm)/{0}.yaml"/>
    """
    semantic = '<param name="robot_description_semantic" textfile="$(find arm)/gripper.srdf"/>'
    both = f"{semantic}{hand.format('left')}{hand.format('right')}"
    described = '<launch><param name="robot_description" textfile="$(find arm)/gripper.urdf"/>'
    of_side = '<rosparam file="$(find arm)/$(arg side)_lists.yaml" subst_value="true"/>'
    controller = "hand: {{type: position_controllers/JointTrajectoryController, joints: [{0}/finger]}}"
    lists = f"controller_list: [{{name: $(arg side)/hand, type: FollowJointTrajectory, joints: [{listed}]}}]"
    folder.write(
        {
            "package.xml": '<package format="2"><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>',
            "gripper.urdf": GRIPPER,
            "gripper.srdf": '<robot name="gripper"/>',
            "demo.launch": f"{described}{both}</launch>",
            "hand.launch": f'<launch><arg name="side"/>{of_side}</launch>',
            **{f"{side}_lists.yaml": lists for side in ("left", "right")},
            **{f"{side}.yaml": controller.format(side) for side in ("left", "right")},
        }
    )
    messages = [finding.message for finding in robots.findings("demo.launch", ("UC653",))]
    assert re.findall(r"does not control joint '([\w/]+)'", " ".join(messages)) == told


@pytest.mark.parametrize(
    ("listed", "told"),
    [
        ("shoulder, elbow, virtual_joint", None),
        ("shoulder, elbow, flange", None),
        ("shoulder, elbow, tool", "tool"),
        ("shoulder, elbow_joint", "elbow_joint"),
    ],
)
def test_a_joint_that_moveit_never_sends_may_be_listed(folder: Folder, listed: str, told: str | None) -> None:
    names = {"shoulder": "revolute", "elbow": "revolute", "tool": "revolute", "flange": "fixed"}
    limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    joints = "".join(
        f'<link name="{name}_link"/><joint name="{name}" type="{kind}"><parent link="base"/>'
        f'<child link="{name}_link"/>{limit}</joint>'
        for name, kind in names.items()
    )
    whole = configured("joints: [shoulder, elbow]", f"joints: [{listed}]")
    files = {name: dedent(text) for name, text in whole.items()}
    folder.write({**files, "arm.urdf": f'<robot name="arm"><link name="base"/>{joints}</robot>'})
    ran = folder.run("lint", "arm.urdf", "ros2_controllers.yaml", "--select", "UC653", "--format", "concise")
    assert [f"'{told}'"] * (told is not None) == re.findall(r"does not control joint ('\w+')", ran.stdout)


@pytest.mark.parametrize(
    ("right", "written", "is_told"),
    [
        ("moveit_simple_controller_manager", "moveit_simple_controler_manager", True),
        ("controller_names", "controller_name", True),
        ("controller_names", "controller_nmaes", True),
        ("moveit_simple_controller_manager", "moveit_fake_controller_manager", False),
        ("controller_names", "names_of_others", False),
    ],
)
def test_a_misspelt_key_of_the_list_of_controllers_is_reported(
    folder: Folder, right: str, written: str, *, is_told: bool
) -> None:
    told = [message for code, _, message in found(folder, f"{right}:", f"{written}:") if code == "UC655"]
    expected = f"MoveIt reads '{right}', not '{written}', so it knows no controller and executes nothing"
    assert told == ([expected] if is_told else [])
