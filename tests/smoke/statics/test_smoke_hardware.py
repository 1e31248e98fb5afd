"""What `<ros2_control>` and transmissions do between controllers and joints: ranges of commands, start, reductions."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import ARMS, Arm, Rover
from smoking import codes, smoked, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.model.geometry import Pose
from urdfctl.rules.smoke.common import LIFT, geared
from urdfctl.smoke.results import RobotResult
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.statics.transmissions import transmissions_of, with_transmissions
from urdfctl.smoke.tasks.task import ControllerTask, MotionFamily

FORWARD = """
controller_manager:
  ros__parameters:
    update_rate: 100
    mover: {type: forward_command_controller/ForwardCommandController}
mover:
  ros__parameters: {joints: [shoulder, elbow], interface_name: position}
"""


def run(folder: Path, urdf: str, yaml: str, engine: str | None = None) -> RobotResult:
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
    assert "UC915" in codes(weak)
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


def driver(urdf: str) -> str:
    return urdf.replace("mock_components/GenericSystem", "my_driver/Arm")


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize(
    ("reduction", "offset", "what"),
    [
        ("50", "0", "the reduction of 50 of joint 'shoulder' acts in the hardware"),
        ("-50", "0", "the reduction of -50 of joint 'shoulder' acts in the hardware: its motor turns the other way"),
        ("1", "0.3", "the offset of 0.3 of joint 'shoulder' acts in the hardware"),
    ],
)
def test_a_transmission_that_hardware_uses_is_reported_as_not_tested(
    tmp_path: Path, engine: str, reduction: str, offset: str, what: str
) -> None:
    ends = f"{reduction}</mechanical_reduction><offset>{offset}</offset>"
    urdf = geared(Arm().urdf(interface="position"), "shoulder", reduction)
    made = run(tmp_path, driver(urdf).replace(f"{reduction}</mechanical_reduction>", ends), FORWARD, engine)
    (mover,) = made.controllers
    assert mover.tested == ("started", "moved", "followed", "held")
    assert mover.untested["transmission"] == what
    assert codes(made) == []


def test_a_transmission_that_simulated_hardware_ignores_is_said_once(tmp_path: Path) -> None:
    urdf = geared(geared(Arm().urdf(interface="position"), "shoulder", "50"), "elbow", "30")
    made = run(tmp_path, urdf, FORWARD)
    (mover,) = made.controllers
    assert (codes(made), mover.verdict.value) == (["UC972"], "skipped")
    assert "transmission" not in mover.untested
    [finding] = made.linted.outcome.diagnostics
    assert finding.message.startswith(
        "mock_components ignores the reduction of 50 of joint 'shoulder', and of 1 more joint"
    )


@pytest.mark.parametrize(
    ("reduction", "simulated", "driven"), [("1", [], []), ("-1", ["UC972", "UC973"], []), ("0", ["UC972"], ["UC975"])]
)
def test_the_sign_of_a_reduction_counts_where_it_is_ignored_and_zero_where_it_is_used(
    tmp_path: Path, reduction: str, simulated: list[str], driven: list[str]
) -> None:
    urdf = geared(Arm().urdf(interface="position"), "elbow", reduction)
    ignored = run(tmp_path, urdf, FORWARD)
    assert (codes(ignored), ignored.controllers[0].verdict.value) == (simulated, "skipped")
    assert codes(run(tmp_path, driver(urdf), FORWARD)) == driven


@pytest.mark.parametrize(("left", "right", "found"), [("30", "30", []), ("30", "-30", []), ("30", "33", ["UC974"])])
def test_wheels_have_equal_gears_on_both_sides(tmp_path: Path, left: str, right: str, found: list[str]) -> None:
    rover = Rover()
    urdf = geared(geared(driver(rover.urdf()), "left_wheel", left), "right_wheel", right)
    assert codes(run(tmp_path, urdf, rover.yaml())) == found
    only_one = geared(driver(rover.urdf()), "left_wheel", left)
    assert codes(run(tmp_path, only_one, rover.yaml())) == ["UC974"]


@pytest.mark.parametrize(("setting", "found"), [("", ["UC972", "UC973"]), ("my_sim/Sim", [])])
def test_gazebo_of_ros1_ignores_reductions_unless_another_class_simulates(
    tmp_path: Path, setting: str, found: list[str]
) -> None:
    kind = f"<robotSimType>{setting}</robotSimType>" if setting else ""
    plugin = f'<gazebo><plugin name="c" filename="libgazebo_ros_control.so">{kind}</plugin></gazebo>'
    end = "<hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>"
    geared_joint = (
        '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
        f'<joint name="lift">{end}</joint><actuator name="m"><mechanicalReduction>-5</mechanicalReduction></actuator>'
        "</transmission>"
    )
    lift = LIFT[: LIFT.index("<ros2_control")] + geared_joint + plugin + "</robot>"
    yaml = "mover:\n  type: position_controllers/JointPositionController\n  joint: lift\n"
    made = smoked(target_of(tmp_path, {"robot.urdf": lift, "controllers.yaml": yaml}), distro="noetic")
    assert codes(made) == found


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_the_radius_multiplier_of_one_side_counts(tmp_path: Path, engine: str) -> None:
    rover = Rover()
    halved = rover.yaml() + "    left_wheel_radius_multiplier: 0.5\n"
    assert codes(run(tmp_path, rover.urdf(), halved, engine)) == ["UC913"]
    both = rover.yaml(radius=2.0) + "    left_wheel_radius_multiplier: 0.5\n    right_wheel_radius_multiplier: 0.5\n"
    assert codes(run(tmp_path, rover.urdf(), both, engine)) == []


# -- limits and transmissions ----------------------------------------------------------------------------------------


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
        [made] = (
            Mechanism("base", {"base": LinkBody("base"), "arm": LinkBody("arm")}, (given,))
            .within_command_ranges()
            .hinges
        )
        other = "effort" if name == "velocity" else "velocity"
        assert (getattr(made, name), getattr(made, other)) == (expected, limit)


@pytest.mark.parametrize(("reduction", "offset"), [("1", "0"), ("1.0", "0.0"), ("one", "none")])
def test_a_transmission_that_changes_nothing_leaves_nothing_out(tmp_path: Path, reduction: str, offset: str) -> None:
    urdf = geared(Arm().urdf(interface="position"), "shoulder", f"{reduction}</mechanical_reduction><offset>{offset}")
    urdf = urdf.replace(f"{offset}</mechanical_reduction>", f"{offset}</offset>")
    for robot in (urdf, driver(urdf)):
        made = run(tmp_path, robot, FORWARD)
        assert (codes(made), made.controllers[0].untested) == ([], {})


def test_joints_that_a_differential_couples_are_not_tested_with_it(tmp_path: Path) -> None:
    ends = (
        '<actuator name="a" role="actuator1"/><actuator name="b" role="actuator2"/>'
        '<joint name="shoulder" role="joint1"/><joint name="elbow" role="joint2"/>'
    )
    kind = "<plugin>transmission_interface/DifferentialTransmission</plugin>"
    coupled = f'<transmission name="t">{kind}{ends}</transmission></ros2_control>'
    urdf = driver(Arm().urdf(interface="position")).replace("</ros2_control>", coupled)
    project = lint_target(
        Loader(Settings(distro="jazzy")), target_of(tmp_path, {"robot.urdf": urdf, "c.yaml": FORWARD}), Selection()
    ).project
    transmissions = transmissions_of(project, "jazzy")
    assert [(transmission.joint, transmission.label) for transmission in transmissions] == [
        ("shoulder", "the coupling"),
        ("elbow", "the coupling"),
    ]
    [task] = with_transmissions(transmissions, [ControllerTask("mover", MotionFamily.FORWARD, ("elbow",), "position")])
    assert task.left_out == (("transmission", "the coupling of joint 'elbow' acts in the hardware"),)
