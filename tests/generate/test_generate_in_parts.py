"""What the generators write one after another belongs together: a robot with all the parts has no error."""

from __future__ import annotations

import json
import re

import pytest
from beginners_robots import BASE
from folder import Folder
from generating import command

ROBOT = re.sub(r"(?s)<transmission.*?</transmission>|<gazebo>.*?</gazebo>", "", BASE["urdf/tern.urdf.xacro"])
INCLUDES = '<xacro:include filename="ros2_control.xacro"/><xacro:include filename="gazebo.xacro"/></robot>'
MANIFEST = "<package format='3'><name>tern</name></package>"
PARTS = {
    "gen-ros2-control": "urdf/ros2_control.xacro",
    "gen-controllers": "config/controllers.yaml",
    "gen-gazebo": "urdf/gazebo.xacro",
}
JAZZY = ("urdf/tern.urdf.xacro", "--distro", "jazzy", "--simulator", "gz")


def test_a_base_that_is_generated_in_parts_has_no_error(folder: Folder) -> None:
    folder.write({"urdf/tern.urdf.xacro": ROBOT, "package.xml": MANIFEST})
    for name, file in PARTS.items():
        assert command(name, *JAZZY, "-o", file).returncode == 0
    folder.write({"urdf/tern.urdf.xacro": ROBOT.replace("</robot>", INCLUDES)})
    assert command("gen-launch", *JAZZY, "-o", "launch/control.launch.py").returncode == 0
    found = json.loads(command("lint", ".", "--format", "json").stdout)["findings"]
    assert [finding["message"] for finding in found if finding["severity"] == "error"] == []


@pytest.mark.parametrize(
    ("words", "interface"),
    [((), "velocity"), (("--command", "effort"), "effort"), (("--type", "position"), "position")],
)
def test_wheels_are_commanded_as_their_controller_does_unless_the_user_says_how(
    folder: Folder, words: tuple[str, ...], interface: str
) -> None:
    folder.write({"urdf/tern.urdf.xacro": ROBOT, "package.xml": MANIFEST})
    made = command("gen-ros2-control", *JAZZY, *words)
    assert set(re.findall(r'<command_interface name="(\w+)"', made.stdout)) == {interface}


@pytest.mark.parametrize(
    ("words", "interface"),
    [((), "Velocity"), (("--interface", "effort"), "Effort"), (("--type", "effort"), "Effort")],
)
def test_transmissions_of_wheels_are_those_that_their_controller_needs(
    folder: Folder, words: tuple[str, ...], interface: str
) -> None:
    folder.write({"urdf/tern.urdf.xacro": ROBOT, "package.xml": MANIFEST})
    made = command("gen-transmissions", "urdf/tern.urdf.xacro", "--distro", "noetic", *words)
    assert set(re.findall(r"hardware_interface/(\w+)JointInterface", made.stdout)) == {interface}


def test_a_caster_that_nothing_commands_needs_no_transmission_beside_those_of_the_wheels(folder: Folder) -> None:
    moment = '<inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>'
    caster = f"""<link name="fork"><inertial><mass value="0.1"/>{moment}</inertial></link>
      <joint name="fork_joint" type="continuous">
        <parent link="base_link"/><child link="fork"/><origin xyz="-0.1 0 0.1"/><axis xyz="0 0 1"/>
      </joint></robot>"""
    with_transmissions = re.sub(r"(?s)<gazebo>.*?</gazebo>", "", BASE["urdf/tern.urdf.xacro"])
    folder.write({"urdf/tern.urdf.xacro": with_transmissions.replace("</robot>", caster), "package.xml": MANIFEST})
    words = ("urdf/tern.urdf.xacro", "--distro", "noetic", "--simulator", "gazebo-classic")
    drive = ("--controller", "base_controller=diff_drive:left_wheel_joint,right_wheel_joint")
    made = command("gen-all", *words, *drive, "-o", "tern_control")
    assert made.returncode == 0, made.stderr
    assert "<transmission" not in (folder.path / "tern_control/urdf/control.xacro").read_text()
    refused = command("gen-transmissions", *words, *drive)
    assert "the robot already has transmissions for all of these joints" in refused.stderr


def test_wheels_that_a_macro_calls_mecanum_get_the_controller_of_such_a_base(folder: Folder) -> None:
    moment = '<inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>'
    calls = "".join(
        f'<xacro:mecanum_wheel name="{end}_{side}" x="{x}" y="{y}"/>'
        for end, x in (("front", 0.1), ("back", -0.1))
        for side, y in (("left", 0.1), ("right", -0.1))
    )
    robot = f"""<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
      <xacro:macro name="mecanum_wheel" params="name x y">
        <link name="${{name}}_link">
          <inertial><mass value="0.3"/>{moment}</inertial>
          <collision><origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.05" length="0.04"/></geometry></collision>
        </link>
        <joint name="${{name}}_wheel" type="continuous">
          <parent link="base"/><child link="${{name}}_link"/><origin xyz="${{x}} ${{y}} 0"/><axis xyz="0 1 0"/>
        </joint>
      </xacro:macro>
      <link name="base"/>{calls}
    </robot>"""
    for macro, kind in (("mecanum_wheel", "mecanum_drive"), ("round_wheel", "diff_drive")):
        folder.write({"cart.xacro": robot.replace("mecanum_wheel", macro)})
        made = command("gen-controllers", "cart.xacro", *JAZZY[1:])
        assert f"type: {kind}_controller/" in made.stdout, made.stderr


def test_interfaces_are_written_although_no_controller_can_be_proposed(folder: Folder) -> None:
    three = "".join(
        f"""<link name="w{n}"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
        <joint name="wheel{n}" type="continuous"><parent link="base"/><child link="w{n}"/>
        <origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/></joint>"""
        for n, x, y in ((1, 0.3, 0.2), (2, 0.3, -0.2), (3, -0.3, 0.2))
    )
    folder.write({"odd.urdf": f'<robot name="odd"><link name="base"/>{three}</robot>'})
    assert command("gen-controllers", "odd.urdf", "--distro", "noetic").returncode != 0
    assert command("gen-transmissions", "odd.urdf", "--distro", "noetic").stdout.count("EffortJointInterface") == 3
