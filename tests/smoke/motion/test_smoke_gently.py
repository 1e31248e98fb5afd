"""A motor that runs at full effort in the usual motion is tried again with a small one, which it may well manage."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoking import target_of, whole
from smoking_engines import EACH_ENGINE

ROD = """
  <link name="{name}"><inertial><origin xyz="0 0 0.4"/><mass value="2"/>
    <inertia ixx="0.11" ixy="0" ixz="0" iyy="0.11" iyz="0" izz="0.003"/></inertial></link>
  <joint name="{joint}" type="revolute"><parent link="{parent}"/><child link="{name}"/><origin xyz="0 0 {height}"/>
    <axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="{effort}" velocity="2"/></joint>
"""
COMMANDED = """<joint name="{}"><command_interface name="position"/>
  <state_interface name="position"/><state_interface name="velocity"/></joint>"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 200
    mover: {type: position_controllers/JointGroupPositionController}
mover:
  ros__parameters: {joints: [root, middle]}
"""


def mast(effort: float) -> str:
    """Two rods that stand on each other, each with a motor at its foot."""
    lower = ROD.format(name="lower", joint="root", parent="world", height=0, effort=effort)
    upper = ROD.format(name="upper", joint="middle", parent="lower", height=0.8, effort=effort)
    hardware = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    joints = "".join(map(COMMANDED.format, ("root", "middle")))
    control = f'<ros2_control name="mast" type="system">{hardware}{joints}</ros2_control>'
    return f'<robot name="mast"><link name="world"/>{lower}{upper}{control}</robot>'


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize(("effort", "swings"), [(20.0, False), (10.0, False), (2.0, True)])
def test_a_motor_swings_only_if_it_cannot_manage_a_small_motion_either(
    effort: float, swings: bool, engine: str, tmp_path: Path
) -> None:
    target = target_of(tmp_path, {"robot.urdf": mast(effort), "controllers.yaml": CONTROLLERS})
    found = {finding.code for finding in whole(target, engine, distro="jazzy").linted.outcome.diagnostics}
    assert ("UC933" in found) is swings
    assert "UC950" in found  # in the worst pose none of them can bear its load


CART = """<robot name="cart"><link name="world"/>
  <link name="bar"><inertial><mass value="10"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="slider" type="prismatic"><parent link="world"/><child link="bar"/><axis xyz="1 0 0"/>
    <limit lower="-15" upper="15" effort="{effort}" velocity="30"/><dynamics damping="10" friction="10"/></joint>
  <ros2_control name="cart" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="slider"><command_interface name="effort"/><state_interface name="position"/></joint></ros2_control>
</robot>"""
PUSHING = """\
controller_manager:
  ros__parameters:
    update_rate: 200
    mover: {type: effort_controllers/JointGroupEffortController}
mover:
  ros__parameters: {joints: [slider]}
"""


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize(("effort", "sticks"), [(1000.0, False), (30.0, False), (8.0, True)])
def test_an_effort_overcomes_the_friction_of_its_joint_unless_that_is_stronger(
    effort: float, sticks: bool, engine: str, tmp_path: Path
) -> None:
    target = target_of(tmp_path, {"robot.urdf": CART.format(effort=effort), "controllers.yaml": PUSHING})
    found = {finding.code for finding in whole(target, engine, distro="jazzy").linted.outcome.diagnostics}
    assert ("UC951" in found) is sticks  # by formula, so that an engine need not tell it
    assert "UC935" not in found
