"""Public robots without any control: a package of what controls them gives lint nothing to say."""

from __future__ import annotations

import pytest
from corpus import CORPUS, needs_corpus
from folder import Folder
from generating import command
from sampling import sample

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target

ROBOTS = {
    "ANYbotics__anymal_b_simple_description/urdf/anymal.urdf": "effort noetic gazebo-classic",
    "Abraheem-1__my_robot_description/urdf/my_robot.xacro": "diff_drive jazzy none",
    "Kinovarobotics__ros2_kortex/kortex_description/grippers/gen3_lite_2f/urdf/"
    "GEN3-LITE-GRIPPER_URDF_SIMPLIFIED_V2.urdf": "gripper jazzy none",
    "LeoRover__leo_common/leo_description/urdf/leo.urdf.xacro": "velocity jazzy gz",
    "PR2__pr2_common/pr2_description/robots/pr2.urdf.xacro": "trajectory kilted none",
    "ROBOTIS-GIT__turtlebot3/turtlebot3_description/urdf/turtlebot3_burger.urdf": "diff_drive rolling gz",
    "UW-RoboSoccer__my_robot_description/urdf/robot.urdf": "velocity humble none",
    "caesar753__braccio_moveit_gazebo_noetic/braccio_description/urdf/xacros/braccio_arm.xacro": (
        "trajectory noetic gazebo-classic"
    ),
    "cambel__ur3/ur_pykdl/urdf/ur3.urdf": "trajectory jazzy mujoco",
    "chenzixin-zn__my_robot_description/urdf/robots/nero/nero_description.urdf": "trajectory humble gazebo-classic",
    "clearpathrobotics__spot_ros/spot_description/urdf/spot.urdf.xacro": "position jazzy gz",
    "davetcoleman__clam/clam_description/urdf/clam.urdf": "position kinetic gazebo-classic",
    "doosan-robotics__doosan-robot2/dsr_description2/urdf/m1013.white.urdf": "trajectory jazzy gz",
    "frankaemika__franka_description/robots/fp3/fp3.urdf.xacro": "trajectory lyrical gz",
    "frankaemika__franka_description/robots/fer/fer.urdf.xacro": "effort melodic gazebo-classic",
    "linorobot__linorobot2/linorobot2_description/urdf/robots/2wd.urdf.xacro": "diff_drive jazzy none",
    "linorobot__linorobot2/linorobot2_description/urdf/robots/4wd.urdf.xacro": "velocity iron none",
    "linorobot__linorobot2/linorobot2_description/urdf/robots/mecanum.urdf.xacro": "mecanum jazzy none",
    "moveit__moveit_resources/panda_description/urdf/panda.urdf": "admittance jazzy none",
    "noshluk2__ROS2-Ultimate-learners-Repository/bazu/urdf/bazu.urdf": "position foxy gazebo-classic",
    "open-dynamic-robot-initiative__robot_properties_solo/src/robot_properties_solo/resources/xacro/"
    "solo12.urdf.xacro": "effort jazzy gz",
    "ros-industrial__abb/abb_irb2400_support/urdf/irb2400.xacro": "trajectory noetic gazebo-classic",
    "ros-industrial__motoman/motoman_gp7_support/urdf/gp7.xacro": "velocity noetic gazebo-classic",
    "ros-industrial__robotiq/robotiq_2f_c2_gripper_visualization/urdf/robotiq_c2_model.xacro": "gripper noetic none",
    "unitreerobotics__unitree_ros/robots/go2_description/urdf/go2_description.urdf": "pid jazzy mujoco",
    "yujinrobot__kobuki/kobuki_description/urdf/kobuki_standalone.urdf.xacro": "diff_drive noetic none",
}
EXPECTED = ("UC449", "UC467", "UC705", "UC706", "UC707")
"""Stand-ins are meant to be found; that later distros lack something is no fault of what is for this one."""


def told(robot: str, distro: str, simulator: str, *folders: str) -> set[tuple[str, str]]:
    """What lint says of a robot, by code and message."""
    settings = Settings(distro, simulator, workspace=folders[-1], package_paths=folders)
    outcome = lint_target(Loader(settings), Target(robot), Selection()).result.outcome
    return {(found.code, found.message) for found in outcome.diagnostics if found.code not in EXPECTED}


@needs_corpus
@pytest.mark.parametrize("path", sample(ROBOTS, 7))
def test_a_package_for_a_robot_without_control_adds_nothing_to_what_lint_says_of_it(path: str, folder: Folder) -> None:
    kind, distro, simulator = ROBOTS[path].split()
    robot, repository = str(CORPUS / path), str(CORPUS / path.partition("/")[0])
    asked = ("--type", kind, "--distro", distro, "--simulator", simulator)
    where = ("--workspace", repository, "--package-path", repository)
    ran = command("gen-all", robot, *asked, *where, "-o", "made")
    assert ran.returncode == 0, ran.stderr
    folders = (str(folder.path), repository)
    alone = told(robot, distro, simulator, *folders)
    assert told("made/urdf/robot.urdf.xacro", distro, simulator, *folders) - alone == set()


@needs_corpus
def test_at_least_twenty_robots_of_as_many_makers_are_tried() -> None:
    assert len({path.partition("/")[0] for path in ROBOTS}) >= 20
