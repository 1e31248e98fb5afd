"""What a migration from one ROS 2 distro to a later one changes, and what it leaves alone."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping
from pathlib import Path

import pytest
from folder import Folder
from humble_packages import HUMBLE, MANIFEST, controllers, migrated

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ALL, ROS2
from urdfctl.catalog.entries import ParameterEntry
from urdfctl.catalog.map_parameters import matching
from urdfctl.catalog.moves import MANAGER, Move, name_moves, parameter_moves
from urdfctl.migrate.options import MigrationOptions
from urdfctl.migrate.steps import STEPS
from urdfctl.migrate.table import rows, table

LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    robot_description = {"robot_description": "<robot/>"}
    files = "config/controllers.yaml"
    return LaunchDescription([
        Node(
            package="controller_manager",
            executable="ros2_control_node",
            parameters=[robot_description, files],
            remappings=[
                ("~/robot_description", "/robot_description"),
            ],
        ),
        Node(
            package="controller_manager",
            executable="spawner",
            arguments=["ctl", "--stopped"],
        ),
        Node(package="controller_manager", executable="spawner", arguments=["other"]),
    ])
"""


def parameters_after(folder: Folder, kind: str, parameters: str, *words: str) -> str:
    """The parameters of a controller after a migration of its file."""
    name = "config/controllers.yaml"
    after = migrated(folder, {name: controllers(kind, parameters)}, *words)[name]
    return textwrap.dedent(after.partition("ctl:\n  ros__parameters:\n")[2])


DIFF = "diff_drive_controller/DiffDriveController"
JTC = "joint_trajectory_controller/JointTrajectoryController"
PID = "pid_controller/PidController"
AS_BEFORE = "allow_nonzero_velocity_at_trajectory_end: true\n"


def test_limits_that_did_not_apply_become_nan_and_the_others_stay(folder: Folder) -> None:
    after = parameters_after(
        folder,
        DIFF,
        """\
        left_wheel_names: [l]  # one
        linear:
          x:
            has_velocity_limits: true
            max_velocity: 1.0
            has_acceleration_limits: false
            max_acceleration: 1.0
            min_acceleration: -1.0
        angular.z.has_velocity_limits: true
        angular.z.min_acceleration: -2.0  # hard
        """,
        *HUMBLE,
        "--to",
        "jazzy",
    )
    assert after == textwrap.dedent("""\
        left_wheel_names: [l]  # one
        linear:
          x:
            max_velocity: 1.0
            max_acceleration: .nan
            max_deceleration: .nan
        angular.z.max_deceleration: -2.0  # hard
        """)


def test_an_integral_limit_becomes_two_in_blocks_and_in_braces(folder: Folder) -> None:
    gains = "gains:\n  a: {p: 1.0, i_clamp: 3.0}\n  b:\n    i_clamp: 4.0  # keep\n" + AS_BEFORE
    assert parameters_after(folder, JTC, gains, *HUMBLE, "--to", "jazzy") == textwrap.dedent("""\
        gains:
          a: {p: 1.0, i_clamp_max: 3.0, i_clamp_min: -3.0}
          b:
            i_clamp_max: 4.0  # keep
            i_clamp_min: -4.0
        allow_nonzero_velocity_at_trajectory_end: true
        """)


def test_old_defaults_are_written_for_the_distros_that_changed_them(folder: Folder) -> None:
    given = "joints: [a]\nconstraints:\n  a: {goal: 0.1}\n"
    assert parameters_after(folder, JTC, given, *HUMBLE, "--to", "lyrical") == textwrap.dedent("""\
        joints: [a]
        constraints:
          a: {goal: 0.1}
          goal_time: 0.0
        allow_nonzero_velocity_at_trajectory_end: true
        """)
    assert parameters_after(folder, JTC, given, "--from", "jazzy", "--to", "jazzy") == given


def test_what_a_person_must_decide_is_a_todo_that_lint_finds(folder: Folder) -> None:
    after = parameters_after(folder, DIFF, "use_stamped_vel: false\nodom_frame_id: odom\n", *HUMBLE, "--to", "jazzy")
    assert re.fullmatch(r"# TODO\(urdfctl\): the controller now reads TwistStamped .*\nodom_frame_id: odom\n", after)
    assert "UC708" in folder.run("lint", "new/config/controllers.yaml", "--distro", "jazzy").stdout


def test_the_side_of_the_steered_wheels_decides_the_new_names(folder: Folder) -> None:
    kind = "ackermann_steering_controller/AckermannSteeringController"
    given = "front_steering: false\nfront_wheels_names: [a, b]\nrear_wheels_names: [c, d]\nrear_wheel_track: 0.4\n"
    after = parameters_after(folder, kind, given, *HUMBLE, "--to", "jazzy")
    assert after == "traction_joints_names: [a, b]\nsteering_joints_names: [c, d]\nsteering_track_width: 0.4\n"


def test_a_type_that_is_gone_becomes_its_successor_with_the_parameters_that_it_needs(folder: Folder) -> None:
    name = "config/c.yaml"
    file = controllers("position_controllers/JointGroupPositionController", "joints: [a]\n")
    after = migrated(folder, {name: file}, "--to", "lyrical", "--only", "yaml")[name]
    assert "ctl: {type: forward_command_controller/ForwardCommandController}" in after
    assert after.endswith("    joints: [a]\n    interface_name: position\n")
    assert migrated(folder, {name: file}, "--to", "jazzy")[name] == file


def test_a_parameter_that_only_the_new_type_reads_is_dropped(folder: Folder) -> None:
    given = "joint: finger\nstate_interfaces: [position]\ngoal_tolerance: 0.1\n"
    name = "config/c.yaml"
    file = controllers("position_controllers/GripperActionController", given)
    after = migrated(folder, {name: file}, "--to", "lyrical", "--only", "yaml")[name]
    assert after.endswith("    joint: finger\n    goal_tolerance: 0.1\n")


def test_an_old_name_is_replaced_although_the_robot_is_said_to_be_for_a_distro_without_it(folder: Folder) -> None:
    kind = "joint_trajectory_controller/JointTrajectoryController"
    after = parameters_after(folder, kind, "open_loop_control: true\n", "--from", "kilted", "--to", "lyrical")
    assert "interpolate_from_desired_state: true\n" in after
    assert "open_loop_control" not in after
    assert "allow_nonzero_velocity_at_trajectory_end" not in after  # its default did not change after kilted


@pytest.mark.parametrize(
    ("given", "wanted"),
    [
        (
            "joints: [a]\ncommand_interfaces: [velocity]\nopen_loop_control: true\n",
            (
                "joints: [a]\ncommand_interfaces: [velocity]\ninterpolate_from_desired_state: true\n"
                "gains.a.ff_velocity_scale: 1.0\n"
            ),
        ),
        (
            "joints: [a]\ncommand_interfaces: [position]\nopen_loop_control: true\n",
            "joints: [a]\ncommand_interfaces: [position]\ninterpolate_from_desired_state: true\n",
        ),
        (
            "joints: [a]\ncommand_interfaces: [velocity]\nopen_loop_control: false\ngains.a.p: 2.0\n",
            "joints: [a]\ncommand_interfaces: [velocity]\ngains.a.p: 2.0\n",
        ),
    ],
)
def test_velocities_in_open_loop_are_passed_on_by_the_gains(folder: Folder, given: str, wanted: str) -> None:
    assert parameters_after(folder, JTC, given, *HUMBLE, "--to", "jazzy") == wanted + AS_BEFORE


@pytest.mark.parametrize(
    ("switch", "gain"), [("", "0.0"), ("enable_feedforward: false\n", "0.0"), ("enable_feedforward: true\n", "0.9")]
)
def test_a_feedforward_that_was_off_stays_off(folder: Folder, switch: str, gain: str) -> None:
    given = "dof_names: [a]\ncommand_interface: velocity\nreference_and_state_interfaces: [velocity]\n"
    gains = "gains.a: {p: 1.0, feedforward_gain: %s}\n"
    after = parameters_after(folder, PID, given + switch + gains % "0.9", "--from", "jazzy", "--to", "kilted")
    assert after == given + gains % gain


def test_the_solver_that_moveit_no_longer_has_becomes_the_one_for_the_same_chains(folder: Folder) -> None:
    given = "arm:\n  kinematics_solver: lma_kinematics_plugin/LMAKinematicsPlugin\n"
    after = migrated(folder, {"config/kinematics.yaml": given}, *HUMBLE, "--to", "jazzy")["config/kinematics.yaml"]
    assert after == given.replace("lma_", "kdl_").replace("LMA", "KDL")


def test_the_packages_and_arguments_of_commands_are_renamed_as_words(folder: Folder) -> None:
    script = """\
# ros2 run ros_ign_bridge parameter_bridge
ros2 launch ros_ign_gazebo ign_gazebo.launch.py ign_args:="$HERE/ros_ign_bridge/a.sdf -r"
cd ros_ign_bridge
"""
    launch = 'cmd = ["ros2 run ros_ign_bridge parameter_bridge ", "ros_ign_bridge is here"]\n'
    files = {"start.sh": script, "launch/arm.launch.py": launch}
    after = migrated(folder, files, *HUMBLE, "--to", "jazzy")
    assert after["start.sh"].splitlines()[1:] == [
        'ros2 launch ros_gz_sim gz_sim.launch.py gz_args:="$HERE/ros_ign_bridge/a.sdf -r"',
        "cd ros_ign_bridge",
    ]
    assert after["launch/arm.launch.py"] == launch.replace("run ros_ign", "run ros_gz")


def test_names_change_as_whole_values_and_not_in_comments_or_other_words(folder: Folder) -> None:
    world = '<!-- ignition-gazebo-x-system --><sdf><plugin filename="libignition-gazebo-imu-system.so"/></sdf>\n'
    sensor = "<sensor><ignition_frame_id>f</ignition_frame_id></sensor>"
    robot = f'<robot name="r"><link name="my_fake_sensor_commands"/>{sensor}</robot>\n'
    after = migrated(folder, {"package.xml": MANIFEST, "a.world": world, "b.urdf": robot}, "--to", "jazzy")
    assert after["package.xml"] == MANIFEST.replace("ros_ign_gazebo", "ros_gz_sim")
    assert after["a.world"] == world.replace("libignition-gazebo-imu-system.so", "gz-sim-imu-system")
    assert after["b.urdf"] == robot.replace("ignition_frame_id", "gz_frame_id")


def test_launch_files_in_python_get_the_topic_and_the_file_of_the_spawner(folder: Folder) -> None:
    files = {"launch/a.launch.py": LAUNCH, "config/controllers.yaml": controllers(DIFF, "odom_frame_id: odom\n")}
    after = migrated(folder, files, "--to", "jazzy", "--only", "launch")["launch/a.launch.py"]
    wanted = LAUNCH.replace("robot_description, files", "files")
    wanted = wanted.replace('"--stopped"]', '"--inactive", "--param-file", files]')
    wanted = re.sub(r" +remappings=\[.*?\],\n(?= +\))", "", wanted, flags=re.DOTALL)
    assert after == wanted
    compile(after, "a.launch.py", "exec")


@pytest.mark.parametrize(
    ("option", "prefix", "expected"),
    [
        ("", "", '"--param-file", files]'),
        (", allow_substs=True", "", '"--param-file", files]'),
        (", allow_substs=True", "$(var prefix)", '"--inactive"]'),
    ],
)
def test_a_spawner_gets_the_path_of_a_file_that_launch_does_not_change(
    folder: Folder, option: str, prefix: str, expected: str
) -> None:
    text = LAUNCH.replace('"~/robot_description", "/', '"~/robot_description", "/a/')
    text = text.replace("robot_description, files", f"ParameterFile(files{option})")
    files = {"launch/a.launch.py": text, "config/c.yaml": controllers(DIFF, f"odom_frame_id: {prefix}odom\n")}
    after = migrated(folder, files, "--to", "jazzy", "--only", "launch")
    assert expected in after["launch/a.launch.py"]
    assert f"ParameterFile(files{option})]" in after["launch/a.launch.py"]
    assert ("launch replaces the substitutions" in after["launch/a.launch.py"]) == bool(prefix)


def value_of(name: str) -> str:
    """A value that a parameter of this name can have."""
    return "[a, b]" if "names" in name else "1.0" if "i_clamp" in name else "true"


@pytest.mark.parametrize("kind", [DIFF, JTC, "ackermann_steering_controller/AckermannSteeringController"])
def test_one_migration_over_several_distros_equals_several_migrations(folder: Folder, kind: str) -> None:
    names = {move.name for move in parameter_moves() if kind in move.controllers and not move.is_default}
    given = "".join(f"{re.sub('<.*>', 'a', name)}: {value_of(name)}\n" for name in sorted(names))
    files = {"config/c.yaml": controllers(kind, given)}
    at_once = migrated(folder, files, *HUMBLE, "--to", "lyrical")
    first = migrated(folder, files, *HUMBLE, "--to", "jazzy")
    assert first != files
    assert migrated(folder, first, "--to", "lyrical") == at_once
    assert migrated(folder, at_once, "--to", "lyrical") == at_once


# -- the data ----------------------------------------------------------------------------------------------------------


def parameters_of(name: str, distro: str) -> Mapping[str, ParameterEntry]:
    """The parameters that a type has in a distro; those that all types have for `*`."""
    kind = CATALOG.controller(name, distro)
    if name == "*":
        return {**CATALOG.common_parameters(distro), **CATALOG.controller_keys(distro)}
    return CATALOG.manager_parameters(distro) if name == MANAGER else kind.parameters if kind else {}


@pytest.mark.parametrize(
    "move", parameter_moves(), ids=lambda move: f"{move.controllers[0].partition('/')[0]}-{move.name}-{move.since}"
)
def test_what_a_move_writes_is_a_parameter_of_its_first_distro_and_what_it_takes_was_one_before(move: Move) -> None:
    for name in move.controllers:
        read = {distro: parameters_of(name, distro) for distro in ROS2}
        assert all(matching(new, read[move.since]) for new in move.becomes if not move.only_set), name
        assert move.is_default or any(matching(move.name, parameters) for parameters in read.values())


def test_every_name_that_replaces_another_has_an_authority_and_a_distro() -> None:
    assert all(moves.authority and moves.since in ROS2 and moves.names for moves in name_moves())


def test_the_new_names_of_hardware_are_those_of_the_catalogue() -> None:
    in_urdf = [moves for moves in name_moves() if "urdf" in moves.parts]
    renamed = [(old, new, moves.since) for moves in in_urdf for old, new in moves.names.items()]
    known = [(CATALOG.hardware_replacement(old, since), new) for old, new, since in renamed if "/" in old]
    assert len(known) > 2
    assert all(replacement == new for replacement, new in known)


def test_the_table_lists_what_lies_between_two_distros(folder: Folder) -> None:
    listed = folder.run("migrate", "--list", "--from", "jazzy", "--to", "lyrical").stdout
    assert "constraints.goal_time" in listed
    assert "i_clamp" not in listed
    assert all(row.authority for _, row in rows(STEPS, MigrationOptions("rolling")))


@pytest.mark.parametrize("target", ROS2)
def test_the_table_fits_a_terminal_and_grows_with_the_way_between_two_distros(target: str) -> None:
    shown = [table(STEPS, MigrationOptions(target, source)) for source in ALL[: ALL.index(target) + 1]]
    assert all(len(line) <= 120 for text in shown for line in text.splitlines())
    assert all("\n    = " in text for text in shown)
    sizes = [len(text.splitlines()) for text in shown]
    assert sizes == sorted(sizes, reverse=True)


def test_a_migration_of_nothing_changes_nothing(folder: Folder, tmp_path: Path) -> None:
    folder.write({"empty/readme.txt": "text"})
    ran = folder.run("migrate", "empty", "--to", "jazzy")
    assert ran.returncode in (0, 2), ran.stderr
    assert tmp_path.exists()


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("FROM ros:humble-ros-base\nRUN apt-get install -y ros-humble-xacro\n", True),
        ("FROM ubuntu:22.04\nENV ROS_DISTRO=humble\n", True),
        ("# FROM ros:humble\nFROM ros:jazzy-ros-base\nRUN echo humble ros-people\n", False),
    ],
)
def test_an_image_with_the_earlier_distro_is_told(folder: Folder, text: str, told: bool) -> None:
    folder.write({"arm/docker/Dockerfile": text, "arm/package.xml": MANIFEST, "arm/start.sh": ". /opt/ros/humble/s\n"})
    ran = folder.run("migrate", "arm", *HUMBLE, "--to", "jazzy", "-o", "new", "--force")
    assert ran.returncode == 0, ran.stderr
    report = (folder.path / "new" / "MIGRATION.md").read_text()
    assert ("the image has humble: make it of jazzy, with its packages" in report) == told
    assert (folder.path / "new" / "docker" / "Dockerfile").read_text() == text


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("controller_interface::return_type update() override;\n", "overrides update() of a controller"),
        ("controller_interface::return_type\narm::Reach::update()\n{\n", "overrides update() of a controller"),
        ("return_type Motor::read() {\n", "overrides read() or write() of hardware"),
        ("return_type update(const rclcpp::Time & time, const rclcpp::Duration & period) override;\n", None),
        ("return_type read(const rclcpp::Time &, const rclcpp::Duration &);\nreturn_type write();\n", None),
        ("// controller_interface::return_type update() override;\nvoid update();\n", None),
    ],
)
def test_code_for_ros2_control_before_it_gave_the_time_is_told(folder: Folder, text: str, told: str | None) -> None:
    folder.write({"arm/include/reach.hpp": f"#pragma once\n{text}", "arm/package.xml": MANIFEST})
    ran = folder.run("migrate", "arm", *HUMBLE, "--to", "jazzy", "-o", "new", "--force")
    assert ran.returncode == 0, ran.stderr
    lines = [line for line in (folder.path / "new" / "MIGRATION.md").read_text().splitlines() if "overrides" in line]
    assert [(told or "") in line and "`include/reach.hpp" in line for line in lines] == ([True] if told else [])
