"""Faults planted in small robots are found in simulation, and without an engine where that is possible."""

from __future__ import annotations

from pathlib import Path

import pytest
from sampling import sample
from smoke_robots import ARMS, ROVERS, Arm, Rover
from smoking import codes, smoked, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE, INSTALLED

EACH_ROVER = pytest.mark.parametrize("rover", sample(ROVERS.values(), 3), ids=sample(ROVERS, 3))
EACH_ARM = pytest.mark.parametrize("arm", sample(ARMS.values(), 3), ids=sample(ARMS, 3))
OPTIONS = {"distro": "jazzy"}


def found(folder: Path, urdf: str, yaml: str, engine: str | None = None) -> list[str]:
    """Return the codes of the findings, in one engine or without."""
    target = target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml})
    made = whole(target, engine, **OPTIONS) if engine else smoked(target, **OPTIONS)
    return codes(made)


def found_anyway(folder: Path, urdf: str, yaml: str) -> list[list[str]]:
    """Return the codes without an engine, then in each installed one."""
    return [found(folder, urdf, yaml, engine) for engine in (None, *INSTALLED)]


@pytest.mark.parametrize("engine", EACH_ENGINE)
@EACH_ROVER
def test_a_sound_rover_passes(tmp_path: Path, rover: Rover, engine: str) -> None:
    target = target_of(tmp_path, {"robot.urdf": rover.urdf(), "controllers.yaml": rover.yaml()})
    made = whole(target, engine, **OPTIONS)
    assert codes(made) == []
    assert verdicts(made) == {"states": "passed deactivate", "base": "passed deactivate"}


@pytest.mark.parametrize("engine", EACH_ENGINE)
@EACH_ARM
def test_a_sound_arm_passes(tmp_path: Path, arm: Arm, engine: str) -> None:
    target = target_of(tmp_path, {"robot.urdf": arm.urdf(), "controllers.yaml": arm.yaml()})
    made = whole(target, engine, **OPTIONS)
    assert [finding.message for finding in made.linted.outcome.diagnostics] == []
    assert verdicts(made) == {"states": "passed deactivate", "mover": "passed deactivate"}
    assert {curve.joint for curve in made.curves} == {"shoulder", "elbow"}


@EACH_ROVER
def test_left_and_right_swapped(tmp_path: Path, rover: Rover) -> None:
    yaml = rover.yaml(left="right", right="left")
    assert found_anyway(tmp_path, rover.urdf(), yaml) == [["UC911"]] * (1 + len(INSTALLED))


@EACH_ROVER
def test_the_axis_of_a_wheel_flipped(tmp_path: Path, rover: Rover) -> None:
    flipped = rover.axis.replace("1", "-1")
    for codes_found in found_anyway(tmp_path, rover.urdf(left=flipped), rover.yaml()):
        assert "UC912" in codes_found
    for codes_found in found_anyway(tmp_path, rover.urdf(left=flipped, right=flipped), rover.yaml()):
        assert "UC912" in codes_found


@EACH_ROVER
def test_wheels_that_cannot_roll_forward(tmp_path: Path, rover: Rover) -> None:
    for codes_found in found_anyway(tmp_path, rover.urdf(left="1 0 0", right="1 0 0"), rover.yaml()):
        assert "UC912" in codes_found


@EACH_ROVER
def test_a_wrong_radius_or_separation(tmp_path: Path, rover: Rover) -> None:
    for codes_found in found_anyway(tmp_path, rover.urdf(), rover.yaml(radius=2)):
        assert "UC913" in codes_found
    for engine in INSTALLED:
        assert found(tmp_path, rover.urdf(), rover.yaml(radius=2), engine) == ["UC913"]
    for codes_found in found_anyway(tmp_path, rover.urdf(), rover.yaml(separation=2)):
        assert "UC913" in codes_found


@EACH_ARM
def test_gains_that_make_it_swing_ever_more(tmp_path: Path, arm: Arm) -> None:
    for gains in ("p: -300.0, d: 10.0", "p: 1000.0, d: 9000.0"):
        for codes_found in found_anyway(tmp_path, arm.urdf(), arm.yaml(gains)):
            assert {"UC916", "UC918"} & set(codes_found)


@EACH_ARM
def test_gains_that_leave_it_swinging(tmp_path: Path, arm: Arm) -> None:
    p = arm.gains.partition(",")[0]
    for codes_found in found_anyway(tmp_path, arm.urdf(), arm.yaml(f"{p}, d: 0.0")):
        assert {"UC916", "UC917"} & set(codes_found)


@pytest.mark.parametrize("arm", sample(list(ARMS.values())[:2], 2), ids=sample(list(ARMS)[:2], 2))
def test_an_effort_too_weak_for_gravity(tmp_path: Path, arm: Arm) -> None:
    assert found(tmp_path, arm.urdf(effort=5.0), arm.yaml()) == ["UC915"]
    for engine in INSTALLED:
        codes_found = found(tmp_path, arm.urdf(effort=5.0), arm.yaml(), engine)
        assert codes_found[0] == "UC915"
        assert not {"UC932", "UC933"} & set(codes_found)


@EACH_ARM
def test_a_velocity_limit_of_zero(tmp_path: Path, arm: Arm) -> None:
    for codes_found in found_anyway(tmp_path, arm.urdf(velocity=0), arm.yaml()):
        assert "UC914" in codes_found


def test_a_velocity_limit_of_zero_that_gazebo_classic_ignores(tmp_path: Path) -> None:
    urdf = Arm().urdf(velocity=0).replace("mock_components/GenericSystem", "gazebo_ros2_control/GazeboSystem")
    assert "gazebo_ros2_control" in urdf
    target = target_of(tmp_path, {"robot.urdf": urdf, "controllers.yaml": Arm().yaml()})
    assert "UC914" not in codes(smoked(target, distro="humble"))


@EACH_ARM
def test_a_mass_that_is_no_number(tmp_path: Path, arm: Arm) -> None:
    for codes_found in found_anyway(tmp_path, arm.urdf(mass="nan"), arm.yaml()):
        assert {"UC901", "UC910"} & set(codes_found)


@EACH_ARM
def test_a_type_that_does_not_exist_and_an_interface_that_is_not_offered(tmp_path: Path, arm: Arm) -> None:
    misspelt = arm.yaml().replace("/JointTrajectoryController", "/JointTrajectoriesController")
    for codes_found in found_anyway(tmp_path, arm.urdf(), misspelt):
        assert codes_found == ["UC903"]
    for codes_found in found_anyway(tmp_path, arm.urdf(interface="position"), arm.yaml()):
        assert codes_found == ["UC905"]


@EACH_ARM
def test_claims_that_conflict(tmp_path: Path, arm: Arm) -> None:
    twice = arm.yaml().replace(
        "    mover:", "    other: {type: effort_controllers/JointGroupEffortController}\n    mover:"
    )
    twice += "other:\n  ros__parameters: {joints: [elbow]}\n"
    target = target_of(tmp_path, {"robot.urdf": arm.urdf(), "controllers.yaml": twice})
    for engine in INSTALLED:
        made = whole(target, engine, started=("mover", "other"), **OPTIONS)
        assert verdicts(made)["other"] == "failed activate"


def test_wheels_too_weak_to_move_the_robot(tmp_path: Path) -> None:
    rover = Rover()
    for engine in INSTALLED:
        assert found(tmp_path, rover.urdf(effort="0.00001"), rover.yaml(), engine) == ["UC941", "UC962"]
    assert found(tmp_path, rover.urdf(effort="0.00001"), rover.yaml()) == ["UC962"]
