"""Legged robots stand on the ground, or are reported as not tested there."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import link
from smoking import codes, target_of, whole
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
def test_a_robot_that_needs_to_balance_is_reported_as_not_tested_on_the_ground(tmp_path: Path, engine: str) -> None:
    two = {"l": (0.0, 0.1), "r": (0.0, -0.1)}
    _, result = on_legs(tmp_path, dog(two), legs(corners=two), engine)
    assert "stood" not in result.tested
    assert result.untested["standing"] in ("it tips over while its joints are held", "the base is held in the air")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_an_arm_without_feet_is_held_in_the_air(tmp_path: Path, engine: str) -> None:
    one = {"l": (0.0, 0.0)}
    _, result = on_legs(tmp_path, dog(one), legs(corners=one), engine)
    assert result.untested["standing"] == "the base is held in the air"
