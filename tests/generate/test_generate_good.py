"""Configurations that real controller managers brought to active: the generators, asked for the same, write equals."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from corpus import SHARED, needs_corpus
from folder import Folder
from generating import command
from sampling import sample

from urdfctl.config.settings import Settings
from urdfctl.control.session import session_of
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target

ARM6 = "--joint joint_1,joint_2,joint_3,joint_4,joint_5,joint_6"
SIX = "--joint base_yaw,shoulder_pitch,elbow_pitch,wrist_roll,wrist_pitch,wrist_yaw"
LEFT_SIX = SIX.replace("base", "left_base").replace(",", ",left_")
TWO_WHEELS = "--left left_wheel_joint --right right_wheel_joint"
FOUR_WHEELS = "--left front_left_joint,rear_left_joint --right front_right_joint,rear_right_joint"
ROS2 = {
    "chained_filter_controller.ChainedFilter__exponential": ["--type filter --joint joint_1 --interface effort"],
    "chained_filter_controller.ChainedFilter__two_stages": ["--type filter --joint joint_1 --interface velocity"],
    "diff_drive_controller.DiffDriveController__four_wheels": [
        f"--type diff_drive {TWO_WHEELS},rear_right_wheel_joint --left rear_left_wheel_joint"
    ],
    "diff_drive_controller.DiffDriveController__open_loop": [f"--type diff_drive {TWO_WHEELS} --state none"],
    "diff_drive_controller.DiffDriveController__velocity_feedback": [
        f"--type diff_drive {TWO_WHEELS} --state velocity"
    ],
    "effort_controllers.JointGroupEffortController__arm6": [f"--type effort --group {ARM6}"],
    "forward_command_controller.ForwardCommandController__arm6_position": [f"--type position {ARM6}"],
    "forward_command_controller.MultiInterfaceForwardCommandController__pos_vel_eff": [
        "--type multi_interface --joint joint_1 --interface position,velocity,effort"
    ],
    "gpio_controllers.GpioCommandController__commands_and_states": [
        "--type gpio --interface flange_io/digital_out_1,vacuum/pump --state flange_io/digital_in_1,vacuum/pressure"
    ],
    "gpio_controllers.GpioCommandController__states_only": ["--type gpio --state vacuum/pressure"],
    "gps_sensor_broadcaster.GPSSensorBroadcaster__covariance_interface": ["--type gps_broadcaster"],
    "joint_state_broadcaster.JointStateBroadcaster__gpio_and_sensor": ["--type joint_state_broadcaster"],
    "joint_trajectory_controller.JointTrajectoryController__arm6_effort_gains": [
        f"--type trajectory --interface effort {ARM6}"
    ],
    "joint_trajectory_controller.JointTrajectoryController__arm6_velocity_gains": [
        f"--type trajectory --interface velocity {ARM6}"
    ],
    "joint_trajectory_controller.JointTrajectoryController__arm7_pos_vel": [
        f"--type trajectory --interface position,velocity {ARM6},joint_7"
    ],
    "magnetometer_broadcaster.MagnetometerBroadcaster__covariance": ["--type magnetometer_broadcaster"],
    "omni_wheel_drive_controller.OmniWheelDriveController__four": ["--type omni --joints wheel_.* --state velocity"],
    "parallel_gripper_action_controller.GripperActionController__effort_limit": ["--type gripper"],
    "pid_controller.PidController__jtc_chained": [
        "--type trajectory --type pid --chain --joint joint_1,joint_2 --state position,velocity"
    ],
    "pid_controller.PidController__position_to_effort": ["--type pid --joint joint_1,joint_2,joint_3"],
    "pid_controller.PidController__velocity_wheels_chained": [
        f"--type diff_drive --type pid --chain --interface velocity --state velocity {TWO_WHEELS}"
    ],
    "pose_broadcaster.PoseBroadcaster__no_tf": ["--type pose_broadcaster"],
    "pose_broadcaster.PoseBroadcaster__tf": ["--type pose_broadcaster"],
    "position_controllers.JointGroupPositionController__two_groups": [
        "--type position --group --joint joint_1,joint_2,joint_3",
        "--type position --group --joint joint_4,joint_5,joint_6",
    ],
    "range_sensor_broadcaster.RangeSensorBroadcaster__infrared": ["--type range_broadcaster"],
    "state_interfaces_broadcaster.StateInterfacesBroadcaster__efforts": [
        f"--type state_interfaces_broadcaster {ARM6} --state effort"
    ],
    "state_interfaces_broadcaster.StateInterfacesBroadcaster__mixed": [
        "--type state_interfaces_broadcaster --state joint_1/position,vacuum/pressure,flange_io/analog_in_1"
    ],
    "velocity_controllers.JointGroupVelocityController__arm6": [f"--type velocity --group {ARM6}"],
    "velocity_controllers.JointGroupVelocityController__two_groups": [
        "--type velocity --group --joint joint_1,joint_2,joint_3",
        "--type velocity --group --joint joint_4,joint_5,joint_6",
    ],
}
ROS1 = {
    "diff_drive_controller__DiffDriveController__four_wheels_limits": [f"--type diff_drive {FOUR_WHEELS}"],
    "diff_drive_controller__DiffDriveController__geometry_from_urdf": [f"--type diff_drive {FOUR_WHEELS}"],
    "diff_drive_controller__DiffDriveController__two_wheels": [
        "--type diff_drive --left front_left_joint --right front_right_joint"
    ],
    "effort_controllers__GripperActionController__tuned": ["--type gripper --joint finger_left_joint"],
    "effort_controllers__JointEffortController__pan_tilt": ["--type effort"],
    "effort_controllers__JointEffortController__six_namespaced": ["--type effort --namespace pico_six"],
    "effort_controllers__JointGroupEffortController__six": ["--type effort --group"],
    "effort_controllers__JointGroupPositionController__pan_tilt": ["--type position --group"],
    "effort_controllers__JointGroupPositionController__six": ["--type position --group"],
    "effort_controllers__JointPositionController__pan_tilt": ["--type position"],
    "effort_controllers__JointPositionController__six": ["--type position"],
    "effort_controllers__JointTrajectoryController__six_prefix": [f"--type trajectory {LEFT_SIX}"],
    "effort_controllers__JointVelocityController__six": ["--type velocity"],
    "joint_state_controller__JointStateController__extra_joints": ["--type joint_state_broadcaster"],
    "joint_state_controller__JointStateController__namespaced": ["--type joint_state_broadcaster --namespace head"],
    "mixed__mobile_manipulator__rover_lift_swing": [
        "--type diff_drive --left front_left_joint --right front_right_joint",
        "--type position --joint lift,swing",
    ],
    "position_controllers__GripperActionController__plain": ["--type gripper --joint finger_left_joint"],
    "position_controllers__JointGroupPositionController__pan_tilt": ["--type position --group"],
    "position_controllers__JointGroupPositionController__six": ["--type position --group"],
    "position_controllers__JointPositionController__pan_tilt": ["--type position"],
    "velocity_controllers__JointGroupVelocityController__pan_tilt": ["--type velocity --group"],
    "velocity_controllers__JointGroupVelocityController__six": ["--type velocity --group"],
    "velocity_controllers__JointPositionController__pan_tilt": ["--type position"],
    "velocity_controllers__JointTrajectoryController__six_constraints": [f"--type trajectory {SIX}"],
    "velocity_controllers__JointVelocityController__pan_tilt": ["--type velocity"],
    "velocity_controllers__JointVelocityController__six_namespaced": ["--type velocity --namespace pico_six"],
}
CASES = [
    *(pytest.param("ros2_good", "jazzy", name, words, id=name) for name, words in ROS2.items()),
    *(pytest.param("ros1_good", "noetic", name, words, id=name) for name, words in ROS1.items()),
]


def claimed(robot: str, controllers: str, distro: str) -> Iterator[tuple[str, list[str], list[str]]]:
    """The type of each controller of a file with what it claims; a controller's own name does not matter."""
    loader = Loader(Settings(distro, workspace=str(Path(robot).parent)))
    session = session_of(lint_target(loader, Target(robot, controllers=(controllers,)), Selection()).project, distro)
    names = {one.name: one.type.type for one in session.controllers if one.type}
    for one in session.controllers:
        assert one.type is not None
        assert one.claims.complete
        assert one.missing == ()
        commands, states = (
            sorted({f"{names.get(first, first)}/{rest}" for first, _, rest in (c.name.partition("/") for c in claims)})
            for claims in (one.claims.command, one.claims.state)
        )
        yield one.type.type, commands, states


@needs_corpus
@pytest.mark.parametrize(("suite", "distro", "name", "commands"), sample(CASES, 4))
def test_the_same_types_claim_the_same(suite: str, distro: str, name: str, commands: list[str], folder: Folder) -> None:
    for file in ("robot.urdf", "controllers.yaml"):
        shutil.copy(SHARED / "truth" / suite / name / file, folder.path / file)
    right = sorted(claimed("robot.urdf", "controllers.yaml", distro))
    written = []
    for words in commands:
        ran = command("gen-controllers", "robot.urdf", *words.split(), "--distro", distro)
        assert (ran.returncode, ran.stderr) == (0, "")
        (folder.path / "written.yaml").write_text(ran.stdout, encoding="utf-8")
        written += [one for one in claimed("robot.urdf", "written.yaml", distro) if one not in written]
    states = [one for one in written if "joint_state" in one[0]]
    assert sorted(one for one in written if one in right or one not in states) == right


@needs_corpus
def test_none_of_them_is_forgotten() -> None:
    assert sorted(path.name for path in (SHARED / "truth" / "ros2_good").iterdir()) == sorted(ROS2)
    assert sorted(path.name for path in (SHARED / "truth" / "ros1_good").iterdir()) == sorted(ROS1)
