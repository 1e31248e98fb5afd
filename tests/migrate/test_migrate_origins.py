"""Packages of one migration that come from different distros, and packages that are at the target already."""

from __future__ import annotations

import pytest
from folder import Folder

ROBOT = """\
<robot name="{name}">
  <link name="base"/>
  <ros2_control name="{name}" type="system">
    <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
    <joint name="{name}_joint"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
ROBOT_OF_ROS1 = """\
<robot name="{name}">
  <link name="base"/><link name="tip"/>
  <joint name="{name}_joint" type="continuous"><parent link="base"/><child link="tip"/></joint>
  <transmission name="t"><type>transmission_interface/SimpleTransmission</type>
    <joint name="{name}_joint"><hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>
    <actuator name="m"/></transmission>
  <gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>
</robot>
"""
TRAJECTORY = """\
controller_manager:
  ros__parameters:
    hand:
      type: joint_trajectory_controller/JointTrajectoryController
hand:
  ros__parameters:
    joints: [{name}_joint]
    command_interfaces: [position]
    state_interfaces: [position]
"""
OF_ROS1 = "states:\n  type: joint_state_controller/JointStateController\nturn:\n"
OF_ROS1 += "  type: velocity_controllers/JointVelocityController\n  joint: {name}_joint\n"
LAUNCH_OF_ROS1 = """\
<launch>
  <param name="robot_description" command="$(find xacro)/xacro $(find {name})/urdf/{name}.urdf"/>
  <rosparam command="load" file="$(find {name})/config/control.yaml"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="states turn"/>
</launch>
"""
NAMING_FILES = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package="controller_manager", executable="spawner", arguments=["hand", "--param-file", "c.yaml"])
    ])
"""


def manifest(name: str, tool: str = "ament_cmake") -> str:
    build = f"<buildtool_depend>{tool}</buildtool_depend><export><build_type>{tool}</build_type></export>"
    return f'<package format="3"><name>{name}</name>{build}</package>\n'


def of_ros1(name: str) -> dict[str, str]:
    texts = {
        "urdf/{name}.urdf": ROBOT_OF_ROS1,
        "config/control.yaml": OF_ROS1,
        "launch/{name}.launch": LAUNCH_OF_ROS1,
    }
    files = {f"{name}/{path.format(name=name)}": text.format(name=name) for path, text in texts.items()}
    return {**files, f"{name}/package.xml": manifest(name, "catkin")}


def of_ros2(name: str) -> dict[str, str]:
    return {
        f"{name}/package.xml": manifest(name),
        f"{name}/urdf/{name}.urdf": ROBOT.format(name=name),
        f"{name}/config/control.yaml": TRAJECTORY.format(name=name),
    }


def text_of(folder: Folder, path: str) -> str:
    return (folder.path / path).read_text()


def test_two_packages_with_files_of_one_name_keep_their_own(folder: Folder) -> None:
    folder.write({**of_ros1("crane"), **of_ros1("winch")})
    ran = folder.run("migrate", ".", "--to", "jazzy", "--simulator", "gz", "--in-place")
    assert ran.returncode == 0, ran.stderr
    for own, other in (("crane", "winch"), ("winch", "crane")):
        assert f'[FindPackageShare("{own}"), "/config/control.yaml"]' in text_of(
            folder, f"{own}/launch/{own}.launch.py"
        )
        assert other not in text_of(folder, f"{own}/package.xml") + text_of(folder, f"{own}/launch/{own}.launch.py")


def test_a_package_that_fits_the_target_is_left_alone_beside_one_of_ros_1(folder: Folder) -> None:
    folder.write({**of_ros1("crane"), **of_ros2("hand_of_today")})
    ran = folder.run("migrate", ".", "--to", "jazzy", "--simulator", "gz", "--in-place")
    assert ran.returncode == 0, ran.stderr
    assert text_of(folder, "hand_of_today/config/control.yaml") == TRAJECTORY.format(name="hand_of_today")


def test_a_package_of_an_earlier_distro_gets_the_old_defaults(folder: Folder) -> None:
    folder.write(of_ros2("hand"))
    ran = folder.run("migrate", ".", "--from", "humble", "--to", "jazzy", "--in-place")
    assert ran.returncode == 0, ran.stderr
    assert "allow_nonzero_velocity_at_trajectory_end: true" in text_of(folder, "hand/config/control.yaml")


@pytest.mark.parametrize("words", [(), ("--from", "kilted")])
def test_a_migration_to_an_earlier_distro_is_refused(folder: Folder, words: tuple[str, ...]) -> None:
    folder.write({**of_ros2("hand"), "hand/launch/hand.launch.py": NAMING_FILES})
    ran = folder.run("migrate", "hand", *words, "--to", "humble")
    assert ran.returncode == 2
    assert ran.stderr.count("\n") == 1
    assert "urdfctl migrates to later distros only" in ran.stderr


def test_a_package_that_may_be_for_the_target_is_not_refused(folder: Folder) -> None:
    folder.write(of_ros2("hand"))
    assert folder.run("migrate", "hand", "--to", "humble").returncode == 0


def test_steps_are_taken_and_left_out_by_their_names(folder: Folder) -> None:
    folder.write(of_ros1("crane"))
    words = ("migrate", "crane", "--to", "jazzy", "--simulator", "gz")
    only = folder.run(*words, "--step", "transmissions").stdout
    assert "+++ b/crane/urdf/crane.urdf" in only
    assert "package.xml" not in only
    without = folder.run(*words, "--skip", "roslaunch,transmissions").stdout
    assert "launch.py" not in without
    assert "+++ b/crane/config/control.yaml" in without
    wrong = folder.run(*words, "--skip", "roslunch")
    assert (wrong.returncode, "did you mean 'roslaunch'?" in wrong.stderr) == (2, True)
    listed = folder.run("migrate", "--list", "--to", "jazzy", "--step", "spawner-types").stdout
    assert listed.startswith(
        "Types of controllers in spawners' arguments: step 'spawner-types', part 'launch', 1 change\n"
    )


def test_the_end_of_a_migration_counts_and_says_how_to_start_the_result(folder: Folder) -> None:
    simulator = '<include file="$(find gazebo_ros)/launch/empty_world.launch"/></launch>'
    start = LAUNCH_OF_ROS1.format(name="crane").replace("</launch>", simulator)
    folder.write({**of_ros1("crane"), "crane/launch/crane.launch": start})
    words = ("migrate", "crane", "--to", "jazzy", "--simulator", "gz", "--in-place", "--force")
    ran = folder.run(*words, "--fail-on", "left")
    assert "left to you (see " in ran.stderr
    assert ran.returncode == int(" 0 left to you" not in ran.stderr)
    report = text_of(folder, "crane/MIGRATION.md")
    commands = report.partition("## Build and start\n\n```\n")[2].splitlines()
    assert commands[0] == "urdfctl lint . --distro jazzy"
    assert "colcon build --packages-up-to crane" in commands
    assert "ros2 launch crane crane.launch.py" in commands
    again = folder.run(*words)
    assert again.stderr.startswith("urdfctl: changed 0 files: 0 applied, 0 choices made")
    assert text_of(folder, "crane/MIGRATION.md") == report
