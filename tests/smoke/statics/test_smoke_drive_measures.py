"""The measures of steered bases, of wheels with kingpins and of wheels that turn off their middle."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoking import smoked, target_of

from urdfctl.rules.smoke.common import ROVER, WHEELS

ARMS = '<ros2_control name="base" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>'
STATES = '<state_interface name="position"/><state_interface name="velocity"/>'
ROUND = '<collision><geometry><cylinder radius="0.1" length="0.04"/></geometry></collision>'
BODY = (
    '<inertial><mass value="{mass}"/><inertia ixx="0.3" ixy="0" ixz="0" iyy="0.3" iyz="0" izz="0.3"/></inertial>'
    '<collision><origin xyz="0.3 0 0"/><geometry><box size="0.4 0.2 0.1"/></geometry></collision>'
)
LIGHT = '<inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>'


def wheel(name: str, place: str, parent: str = "base_link") -> str:
    """Return a wheel that rolls forward about its y axis."""
    return f"""
      <link name="{name}_link">{LIGHT}{ROUND.replace("<geometry>", '<origin rpy="1.5708 0 0"/><geometry>')}</link>
      <joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{name}_link"/>
        <origin xyz="{place}"/><axis xyz="0 1 0"/><limit effort="50" velocity="30"/></joint>"""


def pivot(name: str, place: str) -> str:
    """Return a joint that steers the link of its name."""
    return f"""
      <link name="{name}_fork">{LIGHT}</link>
      <joint name="{name}" type="revolute"><parent link="base_link"/><child link="{name}_fork"/>
        <origin xyz="{place}"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="50" velocity="4"/></joint>"""


def robot(parts: str, controls: dict[str, str]) -> str:
    joints = "".join(f'<joint name="{n}"><command_interface name="{i}"/>{STATES}</joint>' for n, i in controls.items())
    links = BODY.format(mass=20)
    return f'<robot name="base"><link name="base_link">{links}</link>{parts}{ARMS}{joints}</ros2_control></robot>'


def controllers(kind: str, parameters: str) -> str:
    manager = f"controller_manager: {{ros__parameters: {{update_rate: 100, base: {{type: {kind}}}}}}}"
    return f"{manager}\nbase:\n  ros__parameters: {{{parameters}}}\n"


def found(folder: Path, urdf: str, yaml: str) -> list[str]:
    result = smoked(target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml}), distro="jazzy")
    return [
        one.message for one in result.linted.outcome.diagnostics if one.code in ("UC913", "UC951", "UC985", "UC984")
    ]


TRICYCLE = robot(
    pivot("steer", "0.8 0 0.1")
    + wheel("front", "0 0 -0.1", "steer_fork")
    + wheel("l", "0 0.2 0")
    + wheel("r", "0 -0.2 0"),
    {"steer": "position", "front": "velocity"},
)
TRICYCLE_YAML = "traction_joint_name: front, steering_joint_name: steer, wheel_radius: 0.1, wheelbase: {}"


@pytest.mark.parametrize(
    ("wheelbase", "expected"), [(0.8, []), (0.85, []), (1.6, ["wheelbase of 1.6"]), (0.4, ["0.4"])]
)
def test_a_steered_wheel_that_drives_is_a_wheelbase_away_from_those_that_roll_along(
    wheelbase: float, expected: list[str], tmp_path: Path
) -> None:
    yaml = controllers("tricycle_controller/TricycleController", TRICYCLE_YAML.format(wheelbase))
    messages = found(tmp_path, TRICYCLE, yaml)
    assert [word in message for word, message in zip(expected, messages, strict=True)] == [True] * len(expected)


def test_the_wheelbase_is_unknown_without_a_fixed_axle(tmp_path: Path) -> None:
    urdf = robot(
        pivot("steer", "0.8 0 0.1") + wheel("front", "0 0 -0.1", "steer_fork"),
        {"steer": "position", "front": "velocity"},
    )
    yaml = controllers("tricycle_controller/TricycleController", TRICYCLE_YAML.format(3))
    assert found(tmp_path, urdf, yaml) == []


@pytest.mark.parametrize(
    ("friction", "expected"), [("", 0), ('<dynamics friction="3"/>', 0), ('<dynamics friction="90"/>', 1)]
)
def test_a_steering_joint_overcomes_its_friction(friction: str, expected: int, tmp_path: Path) -> None:
    urdf = TRICYCLE.replace(
        'lower="-1" upper="1" effort="50" velocity="4"/>', f'lower="-1" upper="1" effort="50" velocity="4"/>{friction}'
    )
    yaml = controllers("tricycle_controller/TricycleController", TRICYCLE_YAML.format(0.8))
    assert ["friction" in message for message in found(tmp_path, urdf, yaml)] == [True] * expected


ACKERMANN = robot(
    pivot("sr", "0.8 -0.15 0")
    + wheel("fr", "0 -0.07 0", "sr_fork")
    + pivot("sl", "0.8 0.15 0")
    + wheel("fl", "0 0.07 0", "sl_fork")
    + wheel("l", "0 0.22 0")
    + wheel("r", "0 -0.22 0"),
    {"sr": "position", "sl": "position", "r": "velocity", "l": "velocity"},
)


@pytest.mark.parametrize(("track", "expected"), [(0.44, []), (0.3, []), (0.9, ["of 0.9 m, but the robot has 0.44"])])
def test_a_track_is_that_of_the_wheels_or_of_their_kingpins(track: float, expected: list[str], tmp_path: Path) -> None:
    yaml = controllers(
        "ackermann_steering_controller/AckermannSteeringController",
        "traction_joints_names: [r, l], steering_joints_names: [sr, sl], wheelbase: 0.8, traction_track_width: 0.44, "
        f"steering_track_width: {track}, traction_wheels_radius: 0.1, steering_wheels_radius: 0.1",
    )
    messages = found(tmp_path, ACKERMANN, yaml)
    assert [word in message for word, message in zip(expected, messages, strict=True)] == [True] * len(expected)


@pytest.mark.parametrize(("factor", "expected"), [("1.0", 0), ("1.1", 0), ("3.0", 1), ("0.0", 1)])
def test_a_multiplier_of_0_is_not_taken_for_1(factor: str, expected: int, tmp_path: Path) -> None:
    yaml = (WHEELS % "base").rstrip() + f"\n        wheel_separation_multiplier: {factor}\n"
    assert ["separation" in message for message in found(tmp_path, ROVER, yaml)] == [True] * expected


@pytest.mark.parametrize(("off", "expected"), [("0", 0), ("0.004", 0), ("0.03", 1)])
def test_an_eccentric_wheel_is_not_one_of_another_radius(off: str, expected: int, tmp_path: Path) -> None:
    old = '<collision><geometry><cylinder radius="0.1" length="0.04"/>'
    new = old.replace("<geometry>", f'<origin xyz="{off} 0 0"/><geometry>')
    assert [
        "off its middle" in message for message in found(tmp_path, ROVER.replace(old, new, 1), WHEELS % "base")
    ] == [True] * expected


@pytest.mark.parametrize(("off", "expected"), [("0", 0), ("0.03", 1)])
def test_an_eccentric_wheel_that_rolls_along_is_found_too(off: str, expected: int, tmp_path: Path) -> None:
    yaml = controllers("tricycle_controller/TricycleController", TRICYCLE_YAML.format(0.8))
    wheels = TRICYCLE.split('<link name="l_link">')
    urdf = '<link name="l_link">'.join([wheels[0], wheels[1].replace("<origin rpy", f'<origin xyz="{off} 0 0" rpy', 1)])
    assert ["wheel 'l'" in message for message in found(tmp_path, urdf, yaml)] == [True] * expected


@pytest.mark.parametrize(("factor", "expected"), [("1.0", 0), ("0.0", 1)])
def test_a_radius_that_is_multiplied_by_0_is_told(factor: str, expected: int, tmp_path: Path) -> None:
    yaml = (WHEELS % "base").rstrip() + f"\n        left_wheel_radius_multiplier: {factor}\n"
    told = ["left_wheel_radius_multiplier of 0 m" in message for message in found(tmp_path, ROVER, yaml)]
    assert told == [True] * expected
