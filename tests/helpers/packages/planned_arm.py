"""An arm with six joints and a hand, for the tests of MoveIt's configuration, and what is written for it."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

from folder import Folder

from urdfctl.model.robot.build_robot import robot_of
from urdfctl.smoke.robot import Mechanism, mechanism_of
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse

ROW = (
    ("pan", "0 0 1", 0.1),
    ("lift", "0 1 0", 0.3),
    ("elbow", "0 1 0", 0.25),
    ("roll", "0 0 1", 0.1),
    ("bend", "0 1 0", 0.08),
    ("turn", "0 0 1", 0.05),
)
INERTIAL = '<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>'
FINGER = """
  <link name="{name}_finger">{inertial}<collision><origin xyz="0 0 0.03"/>
    <geometry><box size="0.02 0.01 0.06"/></geometry></collision></link>
  <joint name="{name}_finger_joint" type="prismatic"><parent link="hand"/><child link="{name}_finger"/>
    <origin xyz="0 {side}0.01 0.012"/><axis xyz="0 {side}1 0"/>{mimic}
    <limit lower="0" upper="0.04" effort="20" velocity="0.2"/></joint>
"""
JAZZY = ("--distro", "jazzy", "--samples", "1000", "-o", "out")


def arm(limits: str = 'lower="-2.9" upper="2.9"') -> str:
    """Return an arm with six joints, and a hand on it whose second finger follows the first."""
    text, above, height = "", "base_link", 0.1
    for name, axis, length in ROW:
        text += f"""
  <link name="{name}_link">{INERTIAL}<collision><origin xyz="0 0 {length / 2}"/>
    <geometry><cylinder radius="0.04" length="{length}"/></geometry></collision></link>
  <joint name="{name}" type="revolute"><parent link="{above}"/><child link="{name}_link"/>
    <origin xyz="0 0 {height}"/><axis xyz="{axis}"/><limit {limits} effort="90" velocity="2"/></joint>"""
        above, height = f"{name}_link", length
    fingers = FINGER.format(name="left", side="", mimic="", inertial=INERTIAL)
    fingers += FINGER.format(name="right", side="-", mimic='<mimic joint="left_finger_joint"/>', inertial=INERTIAL)
    return f"""<robot name="six">
  <link name="base_link">{INERTIAL}<collision><origin xyz="0 0 0.05"/>
    <geometry><cylinder radius="0.08" length="0.1"/></geometry></collision></link>{text}
  <link name="tool0"/>
  <joint name="tool" type="fixed"><parent link="{above}"/><child link="tool0"/><origin xyz="0 0 0.05"/></joint>
  <link name="hand">{INERTIAL}<collision><geometry><box size="0.04 0.2 0.02"/></geometry></collision></link>
  <joint name="mount" type="fixed"><parent link="tool0"/><child link="hand"/><origin xyz="0 0 0.012"/></joint>
{fingers}</robot>
"""


def semantic(folder: Folder) -> ET.Element:
    """Return the SRDF that was written."""
    return ET.parse(Path(folder.path, "out/config/six.srdf")).getroot()


def mechanism() -> Mechanism:
    """Return the arm in numbers."""
    root = parse(SourceText("six.urdf", arm().encode())).documentElement
    assert root is not None
    found = mechanism_of(robot_of(root))
    assert found is not None
    return found
