"""Controllers that command other controllers move the joints of these; both kinds of grippers; admittance."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import Arm, Rover
from smoking import codes, smoked, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE

from urdfctl.smoke.results import RobotResult

WHEEL_LOOPS = """
controller_manager:
  ros__parameters:
    update_rate: 500
    left: {type: pid_controller/PidController}
    right: {type: pid_controller/PidController}
    base: {type: diff_drive_controller/DiffDriveController}
left:
  ros__parameters:
    dof_names: [left_wheel]
    command_interface: effort
    reference_and_state_interfaces: [velocity]
    gains: {left_wheel: {p: 1.0, i: 20.0, d: 0.0}}
right:
  ros__parameters:
    dof_names: [right_wheel]
    command_interface: effort
    reference_and_state_interfaces: [velocity]
    gains: {right_wheel: {p: 1.0, i: 20.0, d: 0.0}}
base:
  ros__parameters:
    left_wheel_names: [left/left_wheel]
    right_wheel_names: [right/right_wheel]
    position_feedback: false
    wheel_separation: 0.3
    wheel_radius: 0.1
    base_frame_id: base_link
"""
ARM_LOOPS = """
controller_manager:
  ros__parameters:
    update_rate: 500
    loops: {type: pid_controller/PidController}
    mover: {type: joint_trajectory_controller/JointTrajectoryController}
loops:
  ros__parameters:
    dof_names: [shoulder, elbow]
    command_interface: effort
    reference_and_state_interfaces: [position]
    gains:
      shoulder: {p: 400.0, i: 10.0, d: 40.0}
      elbow: {p: 50.0, i: 10.0, d: 2.0}
mover:
  ros__parameters:
    joints: [shoulder, elbow]
    command_joints: [loops/shoulder, loops/elbow]
    command_interfaces: [position]
    state_interfaces: [position, velocity]
"""
ADMITTANCE = """
controller_manager:
  ros__parameters:
    update_rate: 500
    soft: {type: admittance_controller/AdmittanceController}
    mover: {type: joint_trajectory_controller/JointTrajectoryController}
soft:
  ros__parameters:
    joints: [shoulder, elbow]
    command_interfaces: [position]
    state_interfaces: [position, velocity]
    chainable_command_interfaces: [position]
    kinematics: {plugin_name: kdl/KDL, plugin_package: kinematics_interface, base: base_link, tip: fore}
    ft_sensor: {name: wrist, frame: {id: fore}}
    control: {frame: {id: fore}}
    fixed_world_frame: {frame: {id: base_link}}
    gravity_compensation: {frame: {id: fore}, CoG: {pos: [0.0, 0.0, 0.0], force: 0.0}}
    admittance:
      selected_axes: [true, true, true, true, true, true]
      mass: [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
      damping_ratio: [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
      stiffness: [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]
mover:
  ros__parameters:
    joints: [shoulder, elbow]
    command_joints: [soft/shoulder, soft/elbow]
    command_interfaces: [position]
    state_interfaces: [position, velocity]
"""
SENSOR = "".join(f'<state_interface name="{kind}.{way}"/>' for kind in ("force", "torque") for way in ("x", "y", "z"))


def made(folder: Path, urdf: str, yaml: str, engine: str | None = None) -> RobotResult:
    target = target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml})
    return whole(target, engine, distro="jazzy") if engine else smoked(target, distro="jazzy")


def rover() -> str:
    return Rover().urdf().replace('<command_interface name="velocity"/>', '<command_interface name="effort"/>')


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_drive_on_velocity_loops_drives_and_turns(tmp_path: Path, engine: str) -> None:
    result = made(tmp_path, rover(), WHEEL_LOOPS, engine)
    assert codes(result) == []
    assert verdicts(result)["base"] == "passed deactivate"
    assert result.controllers[2].tested == ("started", "drove", "turned")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_drive_on_loops_that_are_too_soft_does_not_drive(tmp_path: Path, engine: str) -> None:
    soft = WHEEL_LOOPS.replace("p: 1.0, i: 20.0", "p: 0.0001, i: 0.0")
    result = made(tmp_path, rover(), soft, engine)
    assert "UC941" in codes(result)
    assert verdicts(result)["base"] == "failed move"


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_drive_finds_wheels_in_the_wrong_list_through_its_loops(tmp_path: Path, engine: str) -> None:
    swapped = WHEEL_LOOPS.replace("[left/left_wheel]", "[right/right_wheel]", 1).replace(
        "right_wheel_names: [right/right_wheel]", "right_wheel_names: [left/left_wheel]"
    )
    assert codes(made(tmp_path, rover(), swapped, engine)) == ["UC911"]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_trajectory_through_loops_is_followed(tmp_path: Path, engine: str) -> None:
    result = made(tmp_path, Arm().urdf(), ARM_LOOPS, engine)
    assert codes(result) == []
    assert verdicts(result) == {"loops": "passed deactivate", "mover": "passed deactivate"}


def test_unstable_loops_are_reported_for_the_controller_that_has_them(tmp_path: Path) -> None:
    stiff = ARM_LOOPS.replace("d: 40.0", "d: 90000.0")
    result = made(tmp_path, Arm().urdf(), stiff)
    assert [trouble.code for trouble in result.linted.outcome.diagnostics] == ["UC916"]
    assert verdicts(result)["loops"] == "failed move"


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_admittance_passes_motions_on_as_long_as_no_force_acts(tmp_path: Path, engine: str) -> None:
    urdf = (
        Arm()
        .urdf(interface="position")
        .replace("</ros2_control>", f'<sensor name="wrist">{SENSOR}</sensor></ros2_control>')
    )
    result = made(tmp_path, urdf, ADMITTANCE, engine)
    assert codes(result) == []
    assert verdicts(result) == {"soft": "passed deactivate", "mover": "passed deactivate"}
    assert result.controllers[0].untested["compliance"] == "no force acts on its sensor"


GRIPPERS = {
    "position": "position_controllers/GripperActionController",
    "effort": "effort_controllers/GripperActionController",
    "parallel": "parallel_gripper_action_controller/GripperActionController",
}


def gripper(kind: str, gains: str = "p: 50.0, i: 10.0, d: 2.0", limits: str = "") -> str:
    return f"""
controller_manager:
  ros__parameters:
    update_rate: 500
    gripper: {{type: {GRIPPERS[kind]}}}
gripper:
  ros__parameters:
    joint: elbow
    {limits}
    gains: {{elbow: {{{gains}}}}}
"""


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("kind", GRIPPERS)
def test_a_gripper_follows(tmp_path: Path, engine: str, kind: str) -> None:
    urdf = Arm().urdf(interface="effort" if kind == "effort" else "position")
    yaml = gripper(kind) if kind == "effort" else gripper(kind).replace("    gains:", "    # gains:")
    result = made(tmp_path, urdf, yaml, engine)
    assert codes(result) == []
    assert result.controllers[0].tested == ("started", "moved", "followed", "held")


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_gripper_without_p_gain_does_not_follow(tmp_path: Path, engine: str) -> None:
    result = made(tmp_path, Arm().urdf(), gripper("effort", "p: 0.0, i: 0.0, d: 0.0"), engine)
    assert verdicts(result) == {"gripper": "failed move"}


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_a_parallel_gripper_that_limits_its_effort_follows(tmp_path: Path, engine: str) -> None:
    limits = "max_effort_interface: elbow/set_gripper_max_effort"
    urdf = Arm().urdf(interface="position")
    with_limit = '<command_interface name="position"/><command_interface name="set_gripper_max_effort"/>'
    urdf = urdf.replace('<command_interface name="position"/>', with_limit)
    yaml = gripper("parallel", limits=limits).replace("    gains:", "    # gains:")
    assert verdicts(made(tmp_path, urdf, yaml, engine)) == {"gripper": "passed deactivate"}
