"""Public robots with sound controllers pass. Findings in other robots are true; the comments say why."""

from __future__ import annotations

import pytest
from corpus import CORPUS, needs_corpus, roots
from sampling import sample
from smoking import codes, verdicts, whole
from smoking_engines import EACH_ENGINE, needs_pybullet

from urdfctl.load.target import Target

SOUND = """
    ROBOTIS-GIT__open_manipulator:open_manipulator_description.urdf.omx_f.omx_f.urdf.xacro
    ROBOTIS-GIT__open_manipulator:open_manipulator_description.urdf.open_manipulator_x.open_manipulator_x.urdf.xacro
    ROBOTIS-GIT__turtlebot3_manipulation:turtlebot3_manipulation_description.urdf.turtlebot3_manipulation.urdf.xacro
    iRobotEducation__create3_sim:irobot_create_common.irobot_create_description.urdf.create3.urdf.xacro
    moveit__moveit_resources:panda_moveit_config.config.panda.urdf.xacro
    reaper1947__smr300l_gazebo_ros2control:description.robot.urdf.xacro
    ros-controls__gazebo_ros2_control:gazebo_ros2_control_demos.urdf.test_cart_effort.xacro.urdf
    ros-controls__gazebo_ros2_control:gazebo_ros2_control_demos.urdf.test_diff_drive.xacro.urdf
    ros-controls__gazebo_ros2_control:gazebo_ros2_control_demos.urdf.test_tricycle_drive.xacro.urdf
    ros-controls__gz_ros2_control:gz_ros2_control_demos.urdf.test_cart_velocity.xacro.urdf
    ros-controls__gz_ros2_control:gz_ros2_control_demos.urdf.test_diff_drive.xacro.urdf
    ros-controls__gz_ros2_control:gz_ros2_control_demos.urdf.test_gripper_mimic_joint_position.xacro.urdf
    ros-controls__gz_ros2_control:gz_ros2_control_demos.urdf.test_pendulum_effort.xacro.urdf
    ros-controls__ros2_control_demos:example_1.description.urdf.rrbot.urdf.xacro
    ros-controls__ros2_control_demos:example_9.description.urdf.rrbot.urdf.xacro
    xArm-Developer__xarm_ros2:xarm_description.urdf.xarm_device.urdf.xacro
""".split()
WITHOUT_HARDWARE = """
    doosan-robotics__doosan-robot2:dsr_description2.xacro.a0509.urdf.xacro
    doosan-robotics__doosan-robot2:dsr_description2.xacro.h2017.urdf.xacro
    doosan-robotics__doosan-robot2:dsr_description2.xacro.m1013.urdf.xacro
    moveit__moveit_resources:fanuc_description.urdf.fanuc.urdf
    moveit__moveit_resources:panda_description.urdf.panda.urdf
    UW-RoboSoccer__my_robot_description:urdf.robot.urdf
""".split()
"""They have controllers of ROS 2 and no <ros2_control> in the description that the corpus pairs these with."""
FAULTY = {
    **{name: {"UC902"} for name in WITHOUT_HARDWARE},
    # it turns right when commanded to turn left: the steering joints' axes point down
    "ros-controls__gz_ros2_control:gz_ros2_control_demos.urdf.test_ackermann_drive.xacro.urdf": {"UC942"},
    # left_wheel_joint is on the right side, at y = -0.05
    "ros-controls__ros2_control_demos:example_2.description.urdf.diffbot.urdf.xacro": {"UC911"},
}
ROOTS = {root["id"]: root for root in roots()}


def target(name: str) -> Target:
    root = ROOTS[name]
    arguments = tuple((key, str(value)) for key, value in (root["args"] or {}).items())
    return Target(str(CORPUS / root["path"]), arguments, controllers=(str(CORPUS / root["controllers"][-1]),))


@needs_corpus
@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("name", sample(SOUND, 6))
def test_a_sound_robot_passes(name: str, engine: str) -> None:
    made = whole(target(name), engine, workspace=str(CORPUS))
    errors = [finding.message for finding in made.linted.outcome.diagnostics if finding.severity.value == "error"]
    assert errors == []
    assert "passed deactivate" in verdicts(made).values()


@needs_corpus
@needs_pybullet
@pytest.mark.parametrize("name", sample(FAULTY, 2))
def test_a_true_fault_is_found(name: str) -> None:
    assert FAULTY[name] <= set(codes(whole(target(name), "pybullet", workspace=str(CORPUS))))
