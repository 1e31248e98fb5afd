"""Plain velocity controllers on the wheels of a base: they drive it, whatever sides the wheels are mounted on."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import Rover
from smoking import codes, smoked, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE

from urdfctl.smoke.results import Smoked

BOTH = """
controller_manager:
  ros__parameters:
    update_rate: 100
    wheels: {type: velocity_controllers/JointGroupVelocityController}
wheels:
  ros__parameters: {joints: [left_wheel, right_wheel]}
"""
EACH = """
controller_manager:
  ros__parameters:
    update_rate: 100
    left: {type: forward_command_controller/ForwardCommandController}
    right: {type: forward_command_controller/ForwardCommandController}
left:
  ros__parameters: {joints: [left_wheel], interface_name: velocity}
right:
  ros__parameters: {joints: [right_wheel], interface_name: velocity}
"""


def of(folder: Path, urdf: str, yaml: str, engine: str) -> Smoked:
    return whole(target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml}), engine, distro="jazzy")


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("axis", ["0 0 1", "0 0 -1"])
def test_one_controller_of_two_wheels_drives_the_base(tmp_path: Path, engine: str, axis: str) -> None:
    made = of(tmp_path, Rover(axis=axis).urdf(), BOTH, engine)
    assert codes(made) == []
    assert [result.tested for result in made.controllers] == [("started", "drove", "turned")]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_controller_for_each_wheel_drives_the_base_too(tmp_path: Path, engine: str) -> None:
    made = of(tmp_path, Rover().urdf(), EACH, engine)
    assert codes(made) == []
    assert verdicts(made) == {"left": "passed deactivate", "right": "passed deactivate"}


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_mirrored_wheels_are_a_warning_and_drive(tmp_path: Path, engine: str) -> None:
    assert codes(of(tmp_path, Rover().urdf(left="0 0 -1"), BOTH, engine)) == ["UC959"]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_wheels_that_are_too_weak_fail_only_the_controller_that_drives(tmp_path: Path, engine: str) -> None:
    made = of(tmp_path, Rover().urdf(effort="0.00001"), EACH, engine)
    assert codes(made) == ["UC941", "UC962"]
    assert verdicts(made) == {"left": "failed move", "right": "skipped activate"}


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_plain_wheels_that_do_not_reach_the_ground_are_found(tmp_path: Path, engine: str) -> None:
    lifted = Rover().urdf().replace('<origin xyz="0 0.15 0"', '<origin xyz="0 0.15 0.05"')
    assert "UC940" in codes(of(tmp_path, lifted, BOTH, engine))


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_wheels_of_a_robot_that_is_fixed_to_the_world_turn_in_the_air(tmp_path: Path, engine: str) -> None:
    fixed = Rover().urdf().replace('"base_footprint"', '"world"')
    made = of(tmp_path, fixed, BOTH, engine)
    assert codes(made) == []
    assert [result.tested for result in made.controllers] == [("started", "moved")]


def test_without_an_engine_the_wheels_are_checked_once_for_the_base(tmp_path: Path) -> None:
    files = {"robot.urdf": Rover().urdf(effort="0.00001"), "controllers.yaml": EACH}
    diagnostics = smoked(target_of(tmp_path, files), distro="jazzy").linted.outcome.diagnostics
    assert [finding.code for finding in diagnostics] == ["UC962"]
