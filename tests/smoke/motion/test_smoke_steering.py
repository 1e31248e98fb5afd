"""Tricycles, and the same base as a bicycle and with Ackermann steering: sound, and with one fault each."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import link
from smoking import codes, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE

from urdfctl.smoke.results import RobotResult

WHEEL = '<origin xyz="0 0 0" rpy="1.5707963 0 0"/><geometry><cylinder radius="0.1" length="0.04"/></geometry>'


def wheel(name: str, parent: str, x: float, y: float) -> str:
    collision = f"<collision>{WHEEL}</collision></link>"
    return (
        link(f"{name}_link", 0.5, 0.003).replace("</link>", collision)
        + f'<joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{name}_link"/>'
        + f'<origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/><limit effort="50" velocity="20"/></joint>'
    )


def fork(name: str, y: float, axis: str) -> str:
    return (
        link(f"{name}_fork", 0.5, 0.003)
        + f'<joint name="{name}" type="revolute"><parent link="base_link"/><child link="{name}_fork"/>'
        + f'<origin xyz="0.3 {y} 0"/><axis xyz="{axis}"/>'
        + '<limit lower="-0.7" upper="0.7" effort="50" velocity="3"/></joint>'
    )


def base(rear: dict[str, float], front: dict[str, float], axis: str = "0 0 1", turned: str = "0 0 0") -> str:
    """Return a base with rear wheels and steered front wheels at some y, and `base_link` turned in `base`."""
    body = link("base_link", 20.0, 0.6, '<box size="0.6 0.3 0.1"/>', "0 0 0.06")
    parts = [wheel(name, "base_link", -0.3, y) for name, y in rear.items()]
    parts += [fork(name, y, axis) + wheel(f"{name}_wheel", f"{name}_fork", 0.0, 0.0) for name, y in front.items()]
    frame = (
        '<link name="frame"/><joint name="frame_joint" type="fixed"><parent link="base_link"/><child link="frame"/>'
        f'<origin xyz="0 0 0" rpy="{turned}"/></joint>'
    )
    states = '<state_interface name="position"/><state_interface name="velocity"/>'
    kinds = {**dict.fromkeys(rear, "velocity"), **dict.fromkeys(front, "position")}
    control = "".join(
        f'<joint name="{name}"><command_interface name="{kind}"/>{states}</joint>' for name, kind in kinds.items()
    )
    hardware = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    control = f'<ros2_control name="b" type="system">{hardware}{control}</ros2_control>'
    return f'<robot name="base">{body}{frame}{"".join(parts)}{control}</robot>'


def yaml(kind: str, rear: str, front: str, wheelbase: float = 0.6, frame: str = "base_link") -> str:
    """Return the controller file of a steered base; the lists begin with the right wheel."""
    tracks = {
        "tricycle": "    traction_track_width: 0.4\n    traction_wheels_radius: 0.1\n",
        "bicycle": "    traction_wheel_radius: 0.1\n",
        "ackermann": "    traction_track_width: 0.4\n    steering_track_width: 0.4\n    traction_wheels_radius: 0.1\n",
    }[kind]
    return f"""
controller_manager:
  ros__parameters:
    update_rate: 100
    base: {{type: {kind}_steering_controller/{kind.capitalize()}SteeringController}}
base:
  ros__parameters:
    traction_joints_names: [{rear}]
    steering_joints_names: [{front}]
    wheelbase: {wheelbase}
    base_frame_id: {frame}
{tracks}"""


def with_casters(urdf: str) -> str:
    """Return a base with a ball on each side, which slides: a bicycle would fall over."""
    balls = "".join(
        link(f"ball{n}", 0.1, 0.001, '<sphere radius="0.05"/>')
        + f'<joint name="ball{n}_mount" type="fixed"><parent link="base_link"/><child link="ball{n}"/>'
        + f'<origin xyz="0 {y} -0.045"/></joint>'
        for n, y in enumerate((-0.2, 0.2))
    )
    return urdf.replace("<ros2_control", f"{balls}<ros2_control")


TWO, STEERED = {"rr": -0.2, "rl": 0.2}, {"fr": -0.2, "fl": 0.2}
SOUND = {
    "bicycle": (with_casters(base({"r": 0.0}, {"f": 0.0})), yaml("bicycle", "r", "f")),
    "tricycle": (base(TWO, {"f": 0.0}), yaml("tricycle", "rr, rl", "f")),
    "ackermann": (base(TWO, STEERED), yaml("ackermann", "rr, rl", "fr, fl")),
}
FAULTS = {
    "a bicycle that steers inversely": (
        with_casters(base({"r": 0.0}, {"f": 0.0}, "0 0 -1")),
        yaml("bicycle", "r", "f"),
        "UC961",
    ),
    "an inverted steering axis": (base(TWO, {"f": 0.0}, "0 0 -1"), yaml("tricycle", "rr, rl", "f"), "UC961"),
    "inverted axes of two pivots": (base(TWO, STEERED, "0 0 -1"), yaml("ackermann", "rr, rl", "fr, fl"), "UC961"),
    "rear wheels exchanged": (base(TWO, {"f": 0.0}), yaml("tricycle", "rl, rr", "f"), "UC960"),
    "pivots exchanged": (base(TWO, STEERED), yaml("ackermann", "rr, rl", "fl, fr"), "UC960"),
    "twice the wheelbase": (base(TWO, {"f": 0.0}), yaml("tricycle", "rr, rl", "f", 1.2), "UC913"),
    "twice the wheelbase of two pivots": (base(TWO, STEERED), yaml("ackermann", "rr, rl", "fr, fl", 1.2), "UC913"),
}


def driven(folder: Path, urdf: str, text: str, engine: str) -> RobotResult:
    return whole(target_of(folder, {"robot.urdf": urdf, "controllers.yaml": text}), engine, distro="jazzy")


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("kind", SOUND)
def test_a_sound_base_drives_and_turns(tmp_path: Path, kind: str, engine: str) -> None:
    made = driven(tmp_path, *SOUND[kind], engine)
    assert codes(made) == []
    assert made.controllers[0].tested == ("started", "drove", "turned")


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_of_steering_is_found(tmp_path: Path, fault: str, engine: str) -> None:
    urdf, text, code = FAULTS[fault]
    made = driven(tmp_path, urdf, text, engine)
    assert code in codes(made)
    if code == "UC961":
        assert "UC942" in codes(made)
        assert verdicts(made)["base"] == "failed move"


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_forward_is_along_the_frame_that_the_controller_names(tmp_path: Path, engine: str) -> None:
    turned = base(TWO, {"f": 0.0}, turned="0 0 3.14159265")
    assert "UC912" in codes(driven(tmp_path, turned, yaml("tricycle", "rr, rl", "f", frame="frame"), engine))
    assert codes(driven(tmp_path, turned, yaml("tricycle", "rr, rl", "f"), engine)) == []
