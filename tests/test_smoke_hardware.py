"""What `<ros2_control>` and transmissions do between controllers and joints: ranges of commands, start, reductions."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import ARMS, Arm, Rover
from smoking import codes, smoked, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE

from urdfctl.model.build_robot import robot_of
from urdfctl.model.geometry import Pose
from urdfctl.smoke.hardware import with_transmissions, within_ranges
from urdfctl.smoke.mechanism import Body, Hinge, Mechanism
from urdfctl.smoke.results import Smoked
from urdfctl.smoke.tasks import Family, Task
from urdfctl.source.span import SourceText
from urdfctl.source.xml import parse

FORWARD = """
controller_manager:
  ros__parameters:
    update_rate: 100
    mover: {type: forward_command_controller/ForwardCommandController}
mover:
  ros__parameters: {joints: [shoulder, elbow], interface_name: position}
"""


def run(folder: Path, urdf: str, yaml: str, engine: str | None = None) -> Smoked:
    target = target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml})
    return whole(target, engine, distro="jazzy") if engine else smoked(target, distro="jazzy")


def ranged(urdf: str, interface: str, least: float, most: float) -> str:
    given = f'<param name="min">{least}</param><param name="max">{most}</param>'
    plain = f'<command_interface name="{interface}"/>'
    return urdf.replace(plain, f'<command_interface name="{interface}">{given}</command_interface>')


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_range_of_efforts_that_does_not_hold_the_weight_is_found(tmp_path: Path, engine: str) -> None:
    arm = ARMS["joints that slide up"]
    assert codes(run(tmp_path, ranged(arm.urdf(), "effort", -200, 200), arm.yaml(), engine)) == []
    assert "UC915" in codes(run(tmp_path, ranged(arm.urdf(), "effort", -20, 20), arm.yaml()))
    weak = run(tmp_path, ranged(arm.urdf(), "effort", -20, 20), arm.yaml(), engine)
    assert "UC932" in codes(weak)
    assert verdicts(weak)["mover"] == "failed move"


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_base_is_driven_within_the_range_of_its_wheels(tmp_path: Path, engine: str) -> None:
    rover = Rover()
    slow = ranged(rover.urdf(), "velocity", -1.0, 1.0)
    made = run(tmp_path, slow, rover.yaml(), engine)
    assert codes(made) == []
    ahead = next(curve for curve in made.curves if curve.quantity == "ahead")
    assert max(ahead.commanded) == pytest.approx(0.18, rel=0.05)
    assert "UC964" in codes(run(tmp_path, ranged(rover.urdf(), "velocity", -0.1, 0.1), rover.yaml()))


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_joint_moves_within_the_range_of_its_commands(tmp_path: Path, engine: str) -> None:
    urdf = ranged(Arm().urdf(interface="position"), "position", 0.0, 0.15)
    made = run(tmp_path, urdf, FORWARD, engine)
    assert codes(made) == []
    assert all(0 <= place <= 0.15 for curve in made.curves for place in curve.commanded)


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_joint_starts_at_its_initial_value(tmp_path: Path, engine: str) -> None:
    start = '<state_interface name="position"><param name="initial_value">0.4</param></state_interface>'
    urdf = Arm().urdf(interface="position").replace('<state_interface name="position"/>', start)
    made = run(tmp_path, urdf, FORWARD, engine)
    assert codes(made) == []
    assert [curve.commanded[0] for curve in made.curves] == pytest.approx([0.4, 0.4], abs=0.01)


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize(
    ("ends", "what"),
    [
        ("<mechanical_reduction>-50</mechanical_reduction>", "the reduction of -50 of joint 'shoulder'"),
        ("<mechanical_reduction>1</mechanical_reduction><offset>0.3</offset>", "the offset of 0.3 of joint 'shoulder'"),
    ],
)
def test_a_transmission_is_reported_as_not_tested(tmp_path: Path, engine: str, ends: str, what: str) -> None:
    transmission = (
        '<transmission name="t"><plugin>transmission_interface/SimpleTransmission</plugin>'
        f'<actuator name="m" role="actuator1"/><joint name="shoulder" role="joint1">{ends}</joint></transmission>'
    )
    urdf = Arm().urdf(interface="position").replace("</ros2_control>", f"{transmission}</ros2_control>")
    (mover,) = run(tmp_path, urdf, FORWARD, engine).controllers
    assert mover.tested == ("started", "moved", "followed", "held")
    assert mover.untested["transmission"] == f"{what} acts in the hardware"


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_the_radius_multiplier_of_one_side_counts(tmp_path: Path, engine: str) -> None:
    rover = Rover()
    halved = rover.yaml() + "    left_wheel_radius_multiplier: 0.5\n"
    assert codes(run(tmp_path, rover.urdf(), halved, engine)) == ["UC913", "UC941"]
    both = rover.yaml(radius=2.0) + "    left_wheel_radius_multiplier: 0.5\n    right_wheel_radius_multiplier: 0.5\n"
    assert codes(run(tmp_path, rover.urdf(), both, engine)) == []


# -- limits and gears ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("limit", "least", "most", "expected"),
    [
        (2.0, -1.0, 1.0, 1.0),
        (2.0, -3.0, 3.0, 2.0),
        (2.0, -0.5, 1.5, 1.5),
        (2.0, -1.5, 0.5, 1.5),
        (None, -1.0, 1.0, 1.0),
        (0.0, -1.0, 1.0, 0.0),
        (2.0, 0.0, 0.0, 2.0),
        (2.0, float("-inf"), float("inf"), 2.0),
        (None, float("-inf"), 1.0, None),
    ],
)
def test_the_limit_of_a_joint_is_at_most_the_greatest_command(
    limit: float | None, least: float, most: float, expected: float | None
) -> None:
    """A limit of 0 has a meaning of its own: the joint does not move, or is not limited."""
    hinge = Hinge("j", "revolute", parent="base", child="arm", pose=Pose(), axis=(0.0, 0.0, 1.0))
    for name in ("velocity", "effort"):
        given = hinge._replace(velocity=limit, effort=limit, ranges=((name, least, most),))
        [made] = within_ranges(Mechanism("base", {"base": Body("base"), "arm": Body("arm")}, (given,))).hinges
        other = "effort" if name == "velocity" else "velocity"
        assert (getattr(made, name), getattr(made, other)) == (expected, limit)


def geared(reduction: str, offset: str, name: str = "j") -> list[tuple[str, str]]:
    """Return what of a controller of joint 'j' is not simulated if a joint has a transmission."""
    text = f"""
        <robot name="r"><link name="a"/><ros2_control name="c" type="system"><transmission name="t">
          <plugin>transmission_interface/SimpleTransmission</plugin><actuator name="m" role="m"/>
          <joint name="{name}" role="j"><mechanical_reduction>{reduction}</mechanical_reduction>
          <offset>{offset}</offset></joint>
        </transmission></ros2_control></robot>
    """
    root = parse(SourceText("/robot.urdf", text.strip().encode())).documentElement
    assert root is not None
    [task] = with_transmissions(robot_of(root), [Task("arm", Family.TRAJECTORY, ("i", "j"), "position")])
    return list(task.left_out)


@pytest.mark.parametrize(
    ("reduction", "offset", "what"),
    [("50", "0.0", "the reduction of 50"), ("1.0", "0.5", "the offset of 0.5"), ("-1", "0.5", "the reduction of -1")],
)
def test_a_reduction_or_an_offset_is_named_as_not_simulated(reduction: str, offset: str, what: str) -> None:
    assert geared(reduction, offset) == [("transmission", f"{what} of joint 'j' acts in the hardware")]
    assert geared(reduction, offset, "another") == []


@pytest.mark.parametrize(("reduction", "offset"), [("1", "0"), ("1.0", "0.0"), ("one", "none")])
def test_a_transmission_that_changes_nothing_leaves_nothing_out(reduction: str, offset: str) -> None:
    assert geared(reduction, offset) == []
