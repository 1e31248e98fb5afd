"""The groups and poses of tools in MoveIt's configuration, for whatever controllers move them."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from folder import Folder
from generating import command
from planned_arm import INERTIAL, JAZZY, ROW, arm, semantic

pytest.importorskip("mujoco")


@pytest.mark.parametrize(("second", "opened"), [("revolute", "0"), ("fixed", "0.9")])
def test_a_jaw_that_turns_alone_is_open_far_from_0_and_fingers_that_turn_together_near_0(
    second: str, opened: str, folder: Folder
) -> None:
    turning = arm().replace("prismatic", "revolute").replace('lower="0" upper="0.04"', 'lower="-0.2" upper="0.9"')
    of_second = 'name="right_finger_joint" type="revolute"'
    folder.write({"six.urdf": turning.replace(of_second, of_second.replace("revolute", second))})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    [value] = semantic(folder).findall("group_state[@name='open']/joint")
    assert value.attrib == {"name": "left_finger_joint", "value": opened}


def test_two_controllers_of_one_tool_have_a_group_together_that_is_its_end_effector(folder: Folder) -> None:
    folder.write({"six.urdf": arm().replace('<mimic joint="left_finger_joint"/>', "")})
    words = ["--controller=left_finger_controller=gripper:left_finger_joint", "--controller"]
    words += ["right_finger_controller=gripper:right_finger_joint", "--controller"]
    words += [f"arm_controller=trajectory:{','.join(name for name, _, _ in ROW)}"]
    assert command("gen-moveit", "six.urdf", *JAZZY, *words).returncode == 0
    root = semantic(folder)
    groups = {one.get("name"): [part.get("name") for part in one] for one in root.findall("group")}
    assert groups["finger"] == ["left_finger_joint", "right_finger_joint"]
    assert [one.get("group") for one in root.findall("end_effector")] == ["finger"]
    listed = yaml.safe_load(Path("out/config/moveit_controllers.yaml").read_text())["moveit_simple_controller_manager"]
    assert sorted(listed["controller_names"]) == ["arm_controller", "left_finger_controller", "right_finger_controller"]
    assert command("lint", "out", "--fail-on", "warning").returncode == 0


def test_gripper_controllers_of_single_joints_on_one_link_are_a_hand_together(folder: Folder) -> None:
    tip = f"""<link name="tip">{INERTIAL}</link><joint name="bent" type="revolute"><parent link="left_finger"/>
      <child link="tip"/><axis xyz="1 0 0"/><limit lower="0" upper="1" effort="9" velocity="1"/></joint>"""
    text = arm().replace('<mimic joint="left_finger_joint"/>', "").replace("</robot>", f"{tip}</robot>")
    folder.write({"six.urdf": text.replace("finger_joint", "part")})
    words = [f"--controller=claw_{name}=gripper:{name}" for name in ("left_part", "right_part", "bent")]
    words += [f"--controller=arm_controller=trajectory:{','.join(name for name, _, _ in ROW)}"]
    assert command("gen-moveit", "six.urdf", *JAZZY, *words).returncode == 0
    root = semantic(folder)
    groups = {one.get("name"): {part.get("name") for part in one} for one in root.findall("group[joint]")}
    assert groups == {"claw": {"left_part", "right_part", "bent"}}
    assert [one.get("parent_link") for one in root.findall("end_effector")] == ["hand"]


def test_a_hand_with_a_finger_of_two_joints_is_one_group_and_the_end_effector_of_the_arm(folder: Folder) -> None:
    tip = f"""<link name="tip">{INERTIAL}</link><joint name="left_finger_bend" type="revolute">
      <parent link="left_finger"/><child link="tip"/><axis xyz="1 0 0"/>
      <limit lower="0" upper="1" effort="9" velocity="1"/></joint>"""
    text = arm().replace('<mimic joint="left_finger_joint"/>', "").replace("</robot>", f"{tip}</robot>")
    folder.write({"six.urdf": text})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    root = semantic(folder)
    groups = {one.get("name"): {part.get("name") for part in one} for one in root.findall("group[joint]")}
    assert groups == {"gripper": {"left_finger_joint", "left_finger_bend", "right_finger_joint"}}
    assert [one.get("parent_link") for one in root.findall("end_effector")] == ["hand"]
    assert command("lint", "out", "--fail-on", "warning").returncode == 0


def test_a_trajectory_controller_of_a_joint_that_fingers_follow_moves_a_tool_whatever_its_name(folder: Folder) -> None:
    folder.write({"six.urdf": arm().replace("finger", "part")})
    words = ["--controller=end_controller=trajectory:left_part_joint", "--controller"]
    words += [f"arm_controller=trajectory:{','.join(name for name, _, _ in ROW)}"]
    assert command("gen-moveit", "six.urdf", *JAZZY, *words).returncode == 0
    assert [one.get("group") for one in semantic(folder).findall("end_effector")] == ["end"]
    assert [one.get("name") for one in semantic(folder).findall("group[chain]")] == ["arm"]


@pytest.mark.parametrize(
    ("asked", "controllers", "groups"),
    [
        (
            "hand=bend,turn",
            {"arm_controller": ["pan", "lift", "elbow", "roll"], "hand_controller": ["bend", "turn"]},
            {"arm": "roll_link", "hand": None, "arm_with_hand": "tool0"},
        ),
        ("arm=base_link:stump", {"arm_controller": [name for name, _, _ in ROW]}, {"arm": "stump"}),
    ],
)
def test_a_group_that_is_a_part_of_a_chain_has_a_controller_of_its_own_and_the_rest_has_one_too(
    asked: str, controllers: dict[str, list[str]], groups: dict[str, str | None], folder: Folder
) -> None:
    bare = arm().split('<link name="left_finger">')[0] + "</robot>"
    folder.write({"six.urdf": bare.replace('"hand"', '"stump"')})
    assert command("gen-moveit", "six.urdf", *JAZZY, "--group", asked).returncode == 0
    listed = yaml.safe_load(Path("out/config/moveit_controllers.yaml").read_text())["moveit_simple_controller_manager"]
    assert {name: listed[name]["joints"] for name in listed["controller_names"]} == controllers
    root = semantic(folder)
    tips = {group.get("name"): group.find("chain") for group in root.findall("group")}
    assert {name: None if tip is None else tip.get("tip_link") for name, tip in tips.items()} == groups
    assert {one.get("group") for one in root.findall("end_effector")} == {"hand"} & {*groups}


def welded(name: str, parent: str) -> str:
    """Return a link without a shape that is fixed to another one."""
    return f"""<link name="{name}"/><joint name="{name}_joint" type="fixed"><parent link="{parent}"/>
      <child link="{name}"/><origin xyz="0 0 0.05"/></joint>"""


@pytest.mark.parametrize(("frame", "tip"), [("hand_tcp", "hand_tcp"), ("ee_grasp", "ee_grasp"), ("camera", "hand")])
def test_the_chain_of_an_arm_ends_at_the_frame_between_the_fingers(frame: str, tip: str, folder: Folder) -> None:
    folder.write({"six.urdf": arm().replace("</robot>", welded(frame, "hand") + "</robot>")})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    root = semantic(folder)
    assert [one.get("tip_link") for one in root.findall("group/chain")] == [tip]
    assert [one.get("parent_link") for one in root.findall("end_effector")] == ["hand"]
    assert command("lint", "out", "--fail-on", "warning").returncode == 0


@pytest.mark.parametrize(("name", "base"), [("base_link_inertia", "base_link"), ("plate", "plate")])
def test_the_chain_of_an_arm_begins_at_the_link_of_which_its_first_one_is_the_inertia(
    name: str, base: str, folder: Folder
) -> None:
    moved = arm().replace('<parent link="base_link"/>', f'<parent link="{name}"/>')
    folder.write({"six.urdf": moved.replace("</robot>", welded(name, "base_link") + "</robot>")})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    assert [one.get("base_link") for one in semantic(folder).findall("group/chain")] == [base]


def test_followers_of_followers_are_in_the_group_of_their_hand(folder: Folder) -> None:
    tip = f"""<link name="tip">{INERTIAL}</link><joint name="tip_joint" type="revolute"><parent link="right_finger"/>
      <child link="tip"/><axis xyz="1 0 0"/><mimic joint="right_finger_joint"/>
      <limit lower="0" upper="1" effort="9" velocity="1"/></joint>"""
    folder.write({"six.urdf": arm().replace("</robot>", f"{tip}</robot>").replace("finger", "part")})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    [hand] = semantic(folder).findall("group[joint]")
    assert [part.get("name") for part in hand] == ["left_part_joint", "right_part_joint", "tip_joint"]
    assert command("lint", "out", "--fail-on", "warning").returncode == 0


@pytest.mark.parametrize(("name", "links"), [("suction_cup", ["suction_cup", "lip"]), ("camera_hand", []), ("bar", [])])
def test_a_tool_without_joints_at_the_end_of_an_arm_is_its_end_effector_by_its_name(
    name: str, links: list[str], folder: Folder
) -> None:
    bare = arm().split('<link name="left_finger">')[0].replace('"hand"', f'"{name}"')
    folder.write({"six.urdf": f"{bare}{welded('lip', name)}</robot>"})
    assert command("gen-moveit", "six.urdf", *JAZZY).returncode == 0
    root = semantic(folder)
    assert [part.get("name") for part in root.findall("group/link")] == links
    effector = {"name": "gripper", "parent_link": "tool0", "group": "gripper", "parent_group": "arm"}
    assert [one.attrib for one in root.findall("end_effector")] == [effector] * bool(links)
    assert {one.get("group") for one in root.findall("group_state")} == {"arm"}
    assert command("lint", "out", "--fail-on", "warning").returncode == 0
    assert command("gen-check", "out") == (0, "", "")
