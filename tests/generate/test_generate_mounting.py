"""Robots without wheels and legs are fixed to the world of a simulator; others stand on its ground."""

from __future__ import annotations

import re

import pytest
from folder import Folder
from generated_robots import ROBOTS
from generating import command

HEIGHTS = {
    "arm": None,
    "arm and gripper": None,
    "diff": 0.16,
    "skid": 0.16,
    "ackermann": 0.16,
    "quadruped": 0.43,
    "mobile manipulator": 0.16,
}
"""The height at which each robot is spawned; None if it is fixed to the world."""


@pytest.mark.parametrize("robot", HEIGHTS)
def test_a_robot_stands_as_its_parts_let_it(robot: str, folder: Folder) -> None:
    folder.write({"r.urdf": f'<robot name="r">{ROBOTS[robot]}</robot>'})
    for distro, simulator in (("noetic", "gazebo-classic"), ("jazzy", "gz")):
        words = ("--distro", distro, "--simulator", simulator, "-o", distro)
        assert command("gen-all", "r.urdf", *words).returncode == 0
        launch = next((folder.path / distro / "launch").iterdir()).read_text()
        found = re.search(r'name="z" default="(.*?)"|"z", default_value="(.*?)"', launch)
        assert found
        assert float(found[1] or found[2]) == (HEIGHTS[robot] or 0.0)
        text = (folder.path / distro / "urdf/robot.urdf.xacro").read_text()
        assert ('<link name="world"/>' in text) == (HEIGHTS[robot] is None)
        assert command("lint", distro, "--fail-on", "warning").returncode == 0
    model = command("convert", "r.urdf", "--to", "mjcf").stdout
    assert ("<freejoint" in model) == (HEIGHTS[robot] is not None)
    ground = re.search(r'name="ground" type="plane" size="0 0 0.05"(?: pos="0 0 (.*?)")?', model)
    assert ground
    assert float(ground[1] or 0.0) == pytest.approx(0.01 - (HEIGHTS[robot] or 0.01))


def test_the_user_decides_whether_it_is_fixed(folder: Folder) -> None:
    folder.write({name: f'<robot name="r">{ROBOTS[name]}</robot>' for name in ("arm", "quadruped")})
    for name, base in (("arm", "free"), ("quadruped", "fixed")):
        words = (name, "--base", base, "--distro", "jazzy", "--simulator", "gz", "-o", "made", "--force")
        assert command("gen-all", *words).returncode == 0
        assert ("world_joint" in (folder.path / "made/urdf/robot.urdf.xacro").read_text()) == (base == "fixed")
    ran = command("convert", "arm", "--to", "mjcf", "--base", "flying")
    assert (ran.returncode, ran.stderr) == (2, "urdfctl: --base must be fixed or free, not 'flying'\n")


def test_a_robot_that_has_a_world_keeps_it(folder: Folder) -> None:
    world = (
        '<link name="world"/><joint name="base" type="fixed"><parent link="world"/><child link="base_link"/></joint>'
    )
    folder.write({"r.urdf": f'<robot name="r">{world}{ROBOTS["arm"]}</robot>'})
    assert command("gen-all", "r.urdf", "--distro", "jazzy", "--simulator", "gz", "-o", "made").returncode == 0
    assert "world" not in (folder.path / "made/urdf/robot.urdf.xacro").read_text()
