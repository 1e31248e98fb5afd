"""Legged robots stand on the ground, or are reported as not tested there."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import link
from smoking import codes, smoked, target_of, whole
from smoking_engines import EACH_ENGINE

from urdfctl.smoke.results import ControllerResult

CORNERS = {"fl": (0.2, 0.15), "fr": (0.2, -0.15), "rl": (-0.2, 0.15), "rr": (-0.2, -0.15)}


def dog(
    corners: dict[str, tuple[float, float]] | None = None, interface: str = "position", kind: str = "revolute"
) -> str:
    """Return a robot with a leg of two joints and a round foot at each corner."""
    parts = [link("base_link", 8.0, 0.1, '<box size="0.4 0.2 0.1"/>')]
    control = []
    for name, (x, y) in (corners or CORNERS).items():
        for joint, parent, child, place in (
            (f"{name}_hip", "base_link", f"{name}_thigh", f"{x} {y} 0"),
            (f"{name}_knee", f"{name}_thigh", f"{name}_shin", "0 0 -0.2"),
        ):
            shape = ('<sphere radius="0.03"/>', "0 0 -0.2") if child.endswith("shin") else ("",)
            parts.append(link(child, 0.5, 0.003, *shape))
            parts.append(
                f'<joint name="{joint}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
                f'<origin xyz="{place}"/><axis xyz="0 1 0"/>'
                '<limit lower="-1.5" upper="1.5" effort="80" velocity="5"/></joint>'
            )
            states = '<state_interface name="position"/><state_interface name="velocity"/>'
            control.append(f'<joint name="{joint}"><command_interface name="{interface}"/>{states}</joint>')
    hardware = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    return (
        f'<robot name="dog">{"".join(parts)}'
        f'<ros2_control name="d" type="system">{hardware}{"".join(control)}</ros2_control></robot>'
    )


def legs(interface: str = "position", gains: str = "", corners: dict[str, tuple[float, float]] | None = None) -> str:
    names = [f"{name}_{part}" for name in corners or CORNERS for part in ("hip", "knee")]
    loops = "".join(f"      {name}: {{{gains}}}\n" for name in names)
    return f"""
controller_manager:
  ros__parameters:
    update_rate: 500
    legs: {{type: joint_trajectory_controller/JointTrajectoryController}}
legs:
  ros__parameters:
    joints: [{", ".join(names)}]
    command_interfaces: [{interface}]
    state_interfaces: [position, velocity]
""" + (f"    gains:\n{loops}" if gains else "")


def on_legs(folder: Path, urdf: str, yaml: str, engine: str) -> tuple[list[str], ControllerResult]:
    made = whole(target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml}), engine, distro="jazzy")
    return codes(made), made.controllers[0]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_robot_with_four_legs_stands(tmp_path: Path, engine: str) -> None:
    found, result = on_legs(tmp_path, dog(), legs(), engine)
    assert found == []
    assert result.tested == ("started", "moved", "followed", "held", "stood")
    assert "standing" not in result.untested


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_robot_stands_on_the_efforts_of_its_control_loops(tmp_path: Path, engine: str) -> None:
    found, result = on_legs(tmp_path, dog(interface="effort"), legs("effort", "p: 60.0, i: 0.0, d: 2.0"), engine)
    assert found == []
    assert "stood" in result.tested


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_loops_that_are_too_soft_to_stand_are_reported_as_not_tested_on_the_ground(tmp_path: Path, engine: str) -> None:
    _, result = on_legs(tmp_path, dog(interface="effort"), legs("effort", "p: 1.5, i: 0.0, d: 0.15"), engine)
    assert "stood" not in result.tested
    assert result.untested["standing"] in (
        "it sinks down while its joints are held",
        "it tips over while its joints are held",
    )


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("corners", [{"l": (0.0, 0.1), "r": (0.0, -0.1)}, {"l": (0.0, 0.0)}])
def test_a_robot_that_needs_to_balance_is_reported_as_not_tested_on_the_ground(
    tmp_path: Path, engine: str, corners: dict[str, tuple[float, float]]
) -> None:
    found, result = on_legs(tmp_path, dog(corners), legs(corners=corners), engine)
    assert (found, "stood" in result.tested) == ([], False)
    tips = "it tips over at spawn unless its base is fixed; if it is, add a link 'world'"
    assert result.untested["standing"] in (tips, "it tips over while its joints are held")


PLATE = '<box size="0.6 0.6 0.04"/>'


def crane(
    base: str = "", mass: float = 10.0, root: str = "base_link", hardware: str = "mock_components/GenericSystem"
) -> str:
    """Return an arm on a base: a column of 0.5 m, and a boom of 0.5 m that swings from upright to level."""
    joint = '<origin xyz="0 0 0.5"/><axis xyz="0 1 0"/><limit lower="0" upper="1.57" effort="100" velocity="2"/>'
    boom = link("boom", 3.0, 0.05).replace("<inertial>", '<inertial><origin xyz="0 0 0.5"/>')
    world = (
        ""
        if root == "base_link"
        else (
            f'<link name="{root}"/><joint name="bolts" type="fixed"><parent link="{root}"/>'
            '<child link="base_link"/></joint>'
        )
    )
    states = '<state_interface name="position"/><state_interface name="velocity"/>'
    return f"""
    <robot name="crane">
      {world}{link("base_link", mass, 0.1, base) if mass else '<link name="base_link"/>'}{boom}
      <joint name="swing" type="revolute"><parent link="base_link"/><child link="boom"/>{joint}</joint>
      <ros2_control name="c" type="system"><hardware><plugin>{hardware}</plugin></hardware>
        <joint name="swing"><command_interface name="position"/>{states}</joint></ros2_control>
    </robot>
    """


SWING = """
controller_manager:
  ros__parameters:
    update_rate: 100
    mover: {type: forward_command_controller/ForwardCommandController}
mover:
  ros__parameters: {joints: [swing], interface_name: position}
"""


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_an_arm_on_a_heavy_plate_stands(tmp_path: Path, engine: str) -> None:
    found, result = on_legs(tmp_path, crane(PLATE), SWING, engine)
    assert (found, "standing" in result.untested) == ([], False)
    assert result.tested == ("started", "moved", "followed", "held", "stood")


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize(
    ("robot", "why"),
    [
        (crane(PLATE, 1.0), "it tips over with swing at 1.3 unless its base is fixed; if it is, add a link 'world'"),
        (crane(), "its base has no collision geometry"),
        (
            crane('<mesh filename="package://absent/base.stl"/>'),
            "the collision geometry of link 'base_link' is unknown",
        ),
        (crane(PLATE).replace('mass value="10.0"', 'mass value="0"'), "its base has no mass"),
        (crane('<sphere radius="2"/>').replace('"0 0 0"', '"0 0 1.5"'), "it balances on a point or a line of its base"),
    ],
)
def test_an_arm_that_does_not_stand_is_reported_as_not_tested_on_the_ground(
    tmp_path: Path, engine: str, robot: str, why: str
) -> None:
    found, result = on_legs(tmp_path, robot, SWING, engine)
    assert (set(found) - {"UC922"}, result.untested["standing"]) == (set(), why)
    assert result.tested == ("started", "moved", "followed", "held")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_robot_that_is_fixed_to_the_world_needs_no_ground(tmp_path: Path, engine: str) -> None:
    found, result = on_legs(tmp_path, crane(PLATE, mass=1.0, root="world"), SWING, engine)
    assert (found, "standing" in result.untested) == ([], False)


def test_an_arm_that_gazebo_would_let_fall_is_a_warning(tmp_path: Path) -> None:
    for hardware, mass, found in (
        ("gz_ros2_control/GazeboSimSystem", 1.0, ["UC977"]),
        ("gz_ros2_control/GazeboSimSystem", 10.0, []),
        ("my_driver/Crane", 1.0, []),
    ):
        files = {"robot.urdf": crane(PLATE, mass, hardware=hardware), "controllers.yaml": SWING}
        assert codes(smoked(target_of(tmp_path, files), distro="jazzy")) == found
