"""Errors of a motion that the hardware of a robot does not share are warnings, and bases whose wheels are not modelled
are not driven."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import Arm, Rover, link
from smoking import codes, smoked, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE

from urdfctl.diagnostic import Severity
from urdfctl.model.geometry import Pose
from urdfctl.smoke.results import RobotResult
from urdfctl.smoke.robot import Hinge, LinkBody, Mechanism
from urdfctl.smoke.statics.undriven import with_own_wheels
from urdfctl.smoke.tasks import ControllerTask, Drive, MotionFamily

WEAK = Arm(mass=20.0)
MOCK = "mock_components/GenericSystem"
CLASSIC = "gazebo_ros2_control/GazeboSystem"
GZ = "gz_ros2_control/GazeboSimSystem"
FORWARD = """
controller_manager:
  ros__parameters:
    mover: {type: forward_command_controller/ForwardCommandController}
mover:
  ros__parameters: {joints: [shoulder, elbow], interface_name: position}
"""
PLUGIN = '<gazebo><plugin name="control" filename="libgazebo_ros_control.so">{}</plugin></gazebo>'
GROUP = "mover: {type: position_controllers/JointGroupPositionController, joints: [shoulder, elbow]}"
ROS1_GAINS = """
gazebo_ros_control:
  pid_gains: {shoulder: {p: 100.0, d: 1.0}, elbow: {p: 100.0, d: 1.0}}
"""
STEERED = """
mover:
  type: diff_drive_controller/DiffDriveController
  left_wheel: left_wheel
  right_wheel: right_wheel
  wheel_separation: 0.3
  wheel_radius: 0.1
  base_frame_id: base_link
  pose_covariance_diagonal: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]
  twist_covariance_diagonal: [0.1, 0.1, 0.1, 0.1, 0.1, 0.1]
"""


def weak_arm(plugin: str = MOCK) -> str:
    """The description of an arm whose motors cannot hold it, with some hardware."""
    urdf = WEAK.urdf(effort=20.0, interface="position").replace(MOCK, plugin)
    return urdf.replace('<link name="base_link"/>', link("base_link", 10.0, 0.1))


def run(folder: Path, urdf: str, yaml: str, engine: str | None = None, distro: str = "humble") -> RobotResult:
    target = target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml})
    return whole(target, engine, distro=distro) if engine else smoked(target, distro=distro)


def severities(result: RobotResult, code: str) -> set[Severity]:
    return {finding.severity for finding in result.linted.outcome.diagnostics if finding.code == code}


def without_ros2_control(urdf: str) -> str:
    return urdf[: urdf.index("<ros2_control")] + urdf[urdf.index("</ros2_control>") + len("</ros2_control>") :]


def transmission(joint: str, interface: str) -> str:
    offered = f"<hardwareInterface>hardware_interface/{interface}</hardwareInterface>"
    return (
        f'<transmission name="{joint}_drive"><type>transmission_interface/SimpleTransmission</type>'
        f'<joint name="{joint}">{offered}</joint><actuator name="{joint}_motor"/></transmission>'
    )


def in_ros1(urdf: str, joints: tuple[str, ...], interface: str, simulation: str = "") -> str:
    parts = "".join(transmission(joint, interface) for joint in joints) + PLUGIN.format(simulation)
    return without_ros2_control(urdf).replace("</robot>", f"{parts}</robot>")


# -- positions that a simulator sets ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("plugin", "severity"),
    [
        (CLASSIC, Severity.WARNING),
        ("arm_driver/Motors", Severity.WARNING),
        (GZ, Severity.ERROR),
        (MOCK, Severity.ERROR),
    ],
)
def test_a_weak_motor_holds_a_position_that_gazebo_classic_sets(
    tmp_path: Path, plugin: str, severity: Severity
) -> None:
    result = run(tmp_path, weak_arm(plugin), FORWARD)
    assert severities(result, "UC915") == {severity}
    assert verdicts(result)["mover"].startswith("warned" if severity is Severity.WARNING else "failed")


@pytest.mark.parametrize(("gains", "severity"), [("", Severity.WARNING), (ROS1_GAINS, Severity.ERROR)])
def test_gains_let_gazebo_of_ros_1_push_a_joint(tmp_path: Path, gains: str, severity: Severity) -> None:
    urdf = in_ros1(weak_arm(), ("shoulder", "elbow"), "PositionJointInterface")
    assert severities(run(tmp_path, urdf, GROUP + gains, distro="noetic"), "UC915") == {severity}


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_what_an_engine_finds_of_such_a_joint_is_a_warning_too(tmp_path: Path, engine: str) -> None:
    assert verdicts(run(tmp_path, weak_arm(CLASSIC), FORWARD, engine))["mover"].startswith("warned")


# -- drivers ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("plugin", "severity"), [("rover_driver/Wheels", Severity.WARNING), (GZ, Severity.ERROR), (MOCK, Severity.ERROR)]
)
def test_a_driver_may_turn_a_motor_the_other_way(tmp_path: Path, plugin: str, severity: Severity) -> None:
    rover = Rover()
    urdf = rover.urdf(left="0 0 -1", right="0 0 -1").replace(MOCK, plugin)
    assert severities(run(tmp_path, urdf, rover.yaml()), "UC912") == {severity}


# -- bases that are not driven ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_base_with_joints_in_gazebo_is_not_put_on_the_ground(tmp_path: Path, engine: str) -> None:
    rover = Rover()
    tie = '<gazebo><joint name="tie" type="ball"><parent>left</parent><child>rear</child></joint></gazebo></robot>'
    light = rover.urdf().replace("</robot>", tie).replace('<link name="front"', '<link name="ahead"')
    light = light.replace('<child link="front"/>', '<child link="ahead"/>')
    result = run(tmp_path, light, rover.yaml(), engine)
    assert codes(result) == []
    base = next(each for each in result.controllers if each.name == "base")
    assert "joint 'tie' of <gazebo> ties links in a way that is not modelled" in base.reason


@pytest.mark.parametrize(
    ("simulation", "verdict"),
    [("", "failed move"), ("<robotSimType>rover_gazebo/Wheels</robotSimType>", "skipped activate")],
)
def test_a_base_with_virtual_wheels_and_its_own_simulation_is_not_judged(
    tmp_path: Path, simulation: str, verdict: str
) -> None:
    upright = Rover().urdf(left="0 1 0", right="0 1 0")
    urdf = in_ros1(upright, ("left_wheel", "right_wheel"), "VelocityJointInterface", simulation)
    assert verdicts(run(tmp_path, urdf, STEERED, distro="noetic"))["mover"] == verdict


@pytest.mark.parametrize(
    ("right", "family"), [("right", MotionFamily.DIFFERENTIAL), ("ghost", MotionFamily.STRUCTURAL)]
)
def test_a_base_is_not_driven_with_wheels_that_the_robot_does_not_have(right: str, family: MotionFamily) -> None:
    hinges = tuple(Hinge(name, "continuous", "base", name, Pose(), (0.0, 1.0, 0.0)) for name in ("left", "right"))
    mechanism = Mechanism("base", {name: LinkBody(name) for name in ("base", "left", "right")}, hinges)
    task = ControllerTask(
        "base", MotionFamily.DIFFERENTIAL, ("left", right), "velocity", drive=Drive(("left",), (right,))
    )
    [made] = with_own_wheels(mechanism, [task])
    assert made.family is family
    assert made.why == ("" if right == "right" else "its wheel 'ghost' is not a movable joint of the robot")


def test_a_link_that_would_be_denser_than_any_metal_is_larger_than_its_shapes(tmp_path: Path) -> None:
    def arm(size: float) -> str:
        shape = f'<link name="fore"><collision><geometry><box size="{size} {size} {size}"/></geometry></collision>'
        heavy = WEAK.urdf(interface="position").replace('<link name="fore">', shape)
        return heavy.replace('"0.02"', '"500"')

    assert "UC992" in codes(run(tmp_path, arm(0.3), FORWARD))
    assert "UC992" not in codes(run(tmp_path, arm(0.01), FORWARD))


@pytest.mark.parametrize(
    ("effort", "interface", "named"), [(200.0, "position", True), (1e6, "position", False), (1e6, "effort", True)]
)
def test_a_motor_that_accelerates_it_easily_moves_whatever_inertia_no_gains_move(
    tmp_path: Path, effort: float, interface: str, named: bool
) -> None:
    shape = '<link name="fore"><collision><geometry><box size="0.3 0.3 0.3"/></geometry></collision>'
    arm = WEAK.urdf(effort=effort, interface=interface).replace('<link name="fore">', shape).replace('"0.02"', '"500"')
    yaml = FORWARD if interface == "position" else WEAK.yaml()
    assert ("UC992" in codes(run(tmp_path, arm, yaml))) is named
