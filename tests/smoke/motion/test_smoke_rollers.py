"""Bases with mecanum and omnidirectional wheels, whose motion follows from the turning of their wheels."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from smoke_robots import link
from smoking import codes, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE

from urdfctl.model.geometry import Pose
from urdfctl.smoke.motion.rollers import Twist, commands, motion_of_base, wheel_speeds
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.tasks.task import Drive

MECANUM = """
controller_manager:
  ros__parameters:
    update_rate: 100
    base: {type: mecanum_drive_controller/MecanumDriveController}
base:
  ros__parameters:
    front_left_wheel_command_joint_name: fl
    front_right_wheel_command_joint_name: fr
    rear_left_wheel_command_joint_name: rl
    rear_right_wheel_command_joint_name: rr
    base_frame_id: base_link
    kinematics:
      base_frame_offset: {x: 0.0, y: 0.0, theta: 0.0}
      wheels_radius: 0.1
      sum_of_robot_center_projection_on_X_Y_axis: 0.5
"""
PLACES = {"fl": (0.2, 0.3), "fr": (0.2, -0.3), "rl": (-0.2, 0.3), "rr": (-0.2, -0.3)}
OMNI = """
controller_manager:
  ros__parameters:
    update_rate: 100
    base: {type: omni_wheel_drive_controller/OmniWheelDriveController}
base:
  ros__parameters:
    wheel_offset: 0.0
    wheel_names: [w0, w1, w2]
    robot_radius: 0.3
    wheel_radius: 0.1
    base_frame_id: base_link
"""


def base(wheels: dict[str, tuple[float, float]], axes: dict[str, tuple[float, float]], more: str = "") -> str:
    """Return a base with wheels at some places, which turn about some axes; their joints have some more elements."""
    made = [link("base_link", 10.0, 0.3)]
    control = []
    for name, (x, y) in wheels.items():
        ax, ay = axes[name]
        turned = f'rpy="1.5707963 0 {math.atan2(ay, ax) + math.pi / 2}"'
        shape = f'<origin xyz="0 0 0" {turned}/><geometry><cylinder radius="0.1" length="0.04"/></geometry>'
        made.append(
            link(f"{name}_link", 0.5, 0.002).replace("</link>", f"<collision>{shape}</collision></link>")
            + f'<joint name="{name}" type="continuous"><parent link="base_link"/><child link="{name}_link"/>'
            + f'<origin xyz="{x} {y} 0.1"/><axis xyz="{ax} {ay} 0"/><limit effort="20" velocity="30"/>{more}</joint>'
        )
        states = '<state_interface name="position"/><state_interface name="velocity"/>'
        control.append(f'<joint name="{name}"><command_interface name="velocity"/>{states}</joint>')
    hardware = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    control_text = f'<ros2_control name="w" type="system">{hardware}{"".join(control)}</ros2_control>'
    return f'<robot name="base">{"".join(made)}{control_text}</robot>'


def mecanum(places: dict[str, tuple[float, float]] | None = None, **axes: tuple[float, float]) -> str:
    return base(places or PLACES, {**dict.fromkeys(PLACES, (0.0, 1.0)), **axes})


def omni(*, outwards: float = 1.0, first: float = 0.0) -> str:
    angles = [first + 2 * math.pi * n / 3 for n in range(3)]
    ways = {f"w{n}": (math.cos(angle), math.sin(angle)) for n, angle in enumerate(angles)}
    places = {name: (0.3 * x, 0.3 * y) for name, (x, y) in ways.items()}
    return base(places, {name: (outwards * x, outwards * y) for name, (x, y) in ways.items()})


def of(folder: Path, urdf: str, yaml: str, engine: str) -> tuple[list[str], str]:
    """Return the codes of the findings, and the verdict on the base."""
    made = whole(target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml}), engine, distro="kilted")
    return codes(made), verdicts(made)["base"]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_sound_mecanum_base_goes_forward_sideways_and_turns(tmp_path: Path, engine: str) -> None:
    assert of(tmp_path, mecanum(), MECANUM, engine) == ([], "passed deactivate")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_sound_omnidirectional_base_goes_forward_sideways_and_turns(tmp_path: Path, engine: str) -> None:
    assert of(tmp_path, omni(), OMNI, engine) == ([], "passed deactivate")
    shifted = OMNI.replace("offset: 0.0", "offset: 0.5")
    assert of(tmp_path, omni(first=0.5), shifted, engine) == ([], "passed deactivate")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_two_mecanum_wheels_exchanged_neither_go_sideways_nor_turn(tmp_path: Path, engine: str) -> None:
    exchanged = mecanum({**PLACES, "fl": PLACES["fr"], "fr": PLACES["fl"]})
    assert of(tmp_path, exchanged, MECANUM, engine) == (["UC941", "UC942", "UC960"], "failed move")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_mecanum_wheel_that_turns_backwards_is_found(tmp_path: Path, engine: str) -> None:
    assert of(tmp_path, mecanum(rr=(0.0, -1.0)), MECANUM, engine) == (["UC912"], "failed move")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_omnidirectional_wheels_whose_axes_point_inwards_go_the_wrong_way(tmp_path: Path, engine: str) -> None:
    assert of(tmp_path, omni(outwards=-1.0), OMNI, engine) == (["UC912"], "failed move")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_mecanum_base_with_twice_its_measures_goes_and_turns_too_far(tmp_path: Path, engine: str) -> None:
    wide = MECANUM.replace("Y_axis: 0.5", "Y_axis: 1.0")
    assert of(tmp_path, mecanum(), wide, engine) == (["UC913"], "failed move")
    small = MECANUM.replace("radius: 0.1", "radius: 0.05")
    assert of(tmp_path, mecanum(), small, engine) == (["UC913"], "failed move")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_damping_keeps_a_mecanum_wheel_from_its_speed(tmp_path: Path, engine: str) -> None:
    damped = base(PLACES, dict.fromkeys(PLACES, (0.0, 1.0)), '<dynamics damping="1000"/>')
    assert of(tmp_path, damped, MECANUM, engine) == (["UC951"], "failed move")


def test_an_offset_of_the_frame_is_reported_as_not_simulated(tmp_path: Path) -> None:
    moved = MECANUM.replace("x: 0.0", "x: 0.1")
    target = target_of(tmp_path, {"robot.urdf": mecanum(), "controllers.yaml": moved})
    (result,) = whole(target, "mujoco", distro="jazzy").controllers
    assert result.reason == "not simulated: its base_frame_offset is not modelled"


# -- the Jacobian ----------------------------------------------------------------------------------------------------

ROLES = (("fl", 1, 1), ("fr", 1, -1), ("rl", -1, 1), ("rr", -1, -1))
FOUR = Drive(driven=tuple(PLACES), base="base_link", radius=0.1, reach=0.5, roles=ROLES)


def on_wheels(places: dict[str, tuple[float, float]], velocity: float = 20.0) -> Mechanism:
    """Return a base with wheels that roll forward, at some places."""
    hinges = [
        Hinge(name, "continuous", "base_link", f"{name}_link", Pose((x, y, 0.1)), (0.0, 1.0, 0.0), velocity=velocity)
        for name, (x, y) in places.items()
    ]
    bodies = [LinkBody("base_link", 10.0), *(LinkBody(hinge.child, 0.5, radius=0.1) for hinge in hinges)]
    return Mechanism("base_link", {body.name: body for body in bodies}, tuple(hinges))


@pytest.mark.parametrize("twist", [Twist(ahead=0.3), Twist(left=-0.2), Twist(turn=0.4), Twist(0.1, 0.2, -0.3)])
def test_the_jacobian_of_the_robot_undoes_the_kinematics_of_the_controller(twist: Twist) -> None:
    """The wheels are at ±0.2 m and ±0.3 m, as the controller's sum of 0.5 m says."""
    angles = wheel_speeds(FOUR, twist)
    assert motion_of_base(on_wheels(PLACES), FOUR, angles) == pytest.approx(twist)


def test_wheels_in_one_place_cannot_move_a_base_in_all_ways() -> None:
    row = {name: (x, 0.3) for name, (x, _) in PLACES.items()}
    assert motion_of_base(on_wheels(row), FOUR, dict.fromkeys(PLACES, 1.0)) is None


@pytest.mark.parametrize("velocity", [1.0, 2.0])
def test_no_wheel_is_commanded_faster_than_it_can_turn(velocity: float) -> None:
    """A part of the limit is left to the loops of the motors."""
    for twist in commands(on_wheels(PLACES, velocity), FOUR):
        fastest = max(map(abs, wheel_speeds(FOUR, twist).values()))
        assert 0.8 * velocity < fastest < velocity
