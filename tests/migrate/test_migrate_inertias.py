"""Inertias that no body can have: gz rejects the robot, so a migration to it raises their moments."""

from __future__ import annotations

from itertools import product

import pytest
from folder import Folder
from ros1_packages import PLUGIN, arm, migrated, transmission

from urdfctl.migrate.classic.inertias import possible
from urdfctl.rules.urdf.inertia import principal_moments

INERTIAL = '<inertial><mass value="1"/><inertia {}/></inertial>'
IMPOSSIBLE = 'ixx="1.0" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"'
LAUNCH = """\
<launch>
  <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
  <param name="robot_description" command="xacro $(find arm)/urdf/arm.xacro"/>
</launch>
"""
SOUND = 'ixx="1.0" ixy="0" ixz="0" iyy="0.6" iyz="0" izz="0.5"'


def with_inertia(moments: str) -> str:
    """A robot of ROS 1 with the same inertia for its two links."""
    robot = arm(transmission("EffortJointInterface"), PLUGIN)
    for name in ("base", "upper"):
        robot = robot.replace(f'<link name="{name}"/>', f'<link name="{name}">{INERTIAL.format(moments)}</link>')
    return robot


def test_moments_are_raised_for_gz_and_the_report_says_so(folder: Folder) -> None:
    after = migrated(folder, {"urdf/arm.xacro": with_inertia(IMPOSSIBLE), "launch/arm.launch": LAUNCH})
    assert (
        after["urdf/arm.xacro"].count('<inertia ixx="1.5005" ixy="0" ixz="0" iyy="0.7005" iyz="0" izz="0.8005"/>') == 2
    )
    assert "no body has the <inertia> of link 'base', and gz rejects the robot" in after["MIGRATION.md"]
    assert "UC136" not in after["MIGRATION.md"]


@pytest.mark.parametrize(("moments", "simulator"), [(SOUND, "gz"), (IMPOSSIBLE, "none")])
def test_moments_that_are_possible_or_not_for_gz_stay(folder: Folder, moments: str, simulator: str) -> None:
    after = migrated(folder, {"urdf/arm.xacro": with_inertia(moments)}, "--simulator", simulator)
    assert after["urdf/arm.xacro"].count(f"<inertia {moments}/>") == 2


def test_moments_of_an_expression_are_left_to_a_person(folder: Folder) -> None:
    moments = IMPOSSIBLE.replace("0.2", "${0.1 + 0.1}")
    after = migrated(folder, {"urdf/arm.xacro": with_inertia(moments)})
    assert after["urdf/arm.xacro"].count(f"<inertia {moments}/>") == 2
    assert "lint finds UC136" in after["MIGRATION.md"]


def test_raised_moments_are_always_possible() -> None:
    for ixx, ixy, ixz, iyy, iyz, izz in product((-1.0, 0.2, 0.7, 1.0), repeat=6):
        new = possible((ixx, ixy, ixz, iyy, iyz, izz)) or (ixx, ixy, ixz, iyy, iyz, izz)
        least, middle, most = principal_moments(new)
        assert least > 0
        assert least + middle >= most
        assert possible(new) is None
