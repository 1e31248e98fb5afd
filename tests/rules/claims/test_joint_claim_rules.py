"""Findings on joints without published states, without commands, and with incomplete limits."""

from __future__ import annotations

from pathlib import Path

import pytest
from control_session import ARM, STATES, component, joint, transmission
from robots import GAZEBO, Bench, controllers, findings, forward

from urdfctl.load.target import Target

FORWARD = "forward_command_controller/ForwardCommandController"
STATE_CONTROLLER = "states: {type: joint_state_controller/JointStateController, publish_rate: 50}\n"


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    return Bench(tmp_path, "UC458", "UC465", "UC466", "UC467", "UC468", "UC469")


# -- states and commands ---------------------------------------------------------------------------------------------


def test_a_publisher_of_states_that_is_not_started_is_named(bench: Bench) -> None:
    yaml = controllers("arm") + "    states: {type: joint_state_broadcaster/JointStateBroadcaster}\n"
    yaml += forward("arm", "shoulder, elbow")
    assert bench.says(ARM, yaml, started=("arm",)) == [
        "info UC465 controller 'states', which publishes the joint states, is not started; spawn it too"
    ]
    assert bench.says(ARM, yaml, started=("states", "arm")) == []


def test_of_ros_1_the_controller_that_publishes_is_named(bench: Bench) -> None:
    yaml = "arm: {type: position_controllers/JointPositionController, joint: elbow}\n"
    [said] = bench.says(transmission("elbow") + GAZEBO, yaml, distro="noetic", started=("arm",))
    assert said == (
        "info UC465 no started controller publishes the joint states; "
        "add one of type 'joint_state_controller/JointStateController'"
    )


@pytest.mark.parametrize(
    ("part", "yaml"),
    [
        (ARM, controllers("arm", kind="acme/Arm")),
        (ARM, controllers("more", kind="imu_sensor_broadcaster/IMUSensorBroadcaster")),
        (
            ARM + '<gazebo><plugin name="states" filename="libgazebo_ros_joint_state_publisher.so"/></gazebo>',
            controllers("arm") + forward("arm", "shoulder, elbow"),
        ),
    ],
    ids=["a controller that is not known", "nothing is moved", "a plugin publishes them"],
)
def test_it_is_silent_on_states_where_somebody_may_publish_them(bench: Bench, part: str, yaml: str) -> None:
    assert bench.says(part, yaml) == []


def test_states_on_a_topic_of_its_own_are_not_published_twice(bench: Bench) -> None:
    kind = "joint_state_broadcaster/JointStateBroadcaster"
    yaml = controllers("states", "more", kind=kind) + "more:\n  ros__parameters: {use_local_topics: true}\n"
    assert bench.says(ARM, yaml, started=("states", "more")) == []


def test_joints_that_nobody_commands_are_told_in_one_finding(bench: Bench) -> None:
    part = component(joint("shoulder") + joint("elbow") + joint("wrist"))
    robot = (
        '<robot name="arm"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>'
        + "".join(
            f'<joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{child}"/></joint>'
            for name, parent, child in (("shoulder", "a", "b"), ("elbow", "b", "c"), ("wrist", "c", "d"))
        )
        + f"{part}</robot>"
    )
    yaml = controllers("arm") + forward("arm", "shoulder")
    assert "info UC467 joints 'elbow' and 'wrist' are not commanded by any controller in these files" in bench.says(
        robot, yaml
    )


@pytest.mark.parametrize(
    ("name", "told"),
    [
        (
            "velocty",
            ["no hardware exports state interface 'velocty'; the joint states have no effort; did you"],
        ),
        ("velocity", []),
        ("effort", []),
        ("$(var effort)", []),
    ],
)
def test_an_interface_is_published_under_another_name_where_it_is_there(
    tmp_path: Path, name: str, told: list[str]
) -> None:
    yaml = controllers("states", kind="joint_state_broadcaster/JointStateBroadcaster")
    yaml += f"states:\n  ros__parameters: {{map_interface_to_joint_state: {{effort: {name}}}}}\n"
    bench = Bench(tmp_path, "UC470")
    assert [finding.message.partition(" mean")[0] for finding in bench.lint(ARM, yaml)] == told
    assert bench.lint("", yaml) == []


# -- hardware that is not active -------------------------------------------------------------------------------------

ASLEEP = """    hardware_components_initial_state: {inactive: [other, hw]}
    arm: {type: forward_command_controller/ForwardCommandController}
"""


def asleep(more: str = "") -> str:
    return "controller_manager:\n  ros__parameters:\n    update_rate: 100\n" + more + ASLEEP + forward("arm", "elbow")


def test_inactive_hardware_stops_controllers_from_jazzy_on_unless_they_are_allowed(bench: Bench) -> None:
    assert "error UC458" in bench.codes(ARM, asleep(), started=("arm",))
    assert "error UC458" not in bench.codes(ARM, asleep(), started=("arm",), distro="humble")
    allowed = "    defaults: {allow_controller_activation_with_inactive_hardware: true}\n"
    assert "error UC458" not in bench.codes(ARM, asleep(allowed), started=("arm",))
    assert "error UC458" not in bench.codes(ARM, asleep())


@pytest.mark.parametrize(("executable", "severities"), [("hardware_spawner", []), ("spawner", ["error"])])
def test_a_launch_file_that_activates_the_hardware_is_believed(
    tmp_path: Path, executable: str, severities: list[str]
) -> None:
    bench = Bench(tmp_path, "UC458")
    bench.lint(ARM, asleep())
    (tmp_path / "robot.launch.xml").write_text(
        f"""
        <launch>
          <let name="description" value="$(command 'xacro $(dirname)/robot.urdf')"/>
          <node pkg="robot_state_publisher" exec="robot_state_publisher">
            <param name="robot_description" value="$(var description)"/>
          </node>
          <node pkg="controller_manager" exec="ros2_control_node"><param from="$(dirname)/controllers.yaml"/></node>
          <node pkg="controller_manager" exec="{executable}" args="hw --activate"/>
          <node pkg="controller_manager" exec="spawner" args="arm"/>
        </launch>
        """,
        encoding="utf-8",
    )
    target = Target(str(tmp_path / "robot.urdf"), launch=str(tmp_path / "robot.launch.xml"))
    found = findings(target, distro="jazzy", workspace=str(tmp_path))
    assert [finding.severity.value for finding in found if finding.code == "UC458"] == severities


# -- limits and gains of ROS 1 ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("interface", "limits", "told"),
    [
        ("EffortJointInterface", "has_velocity_limits: true, max_velocity: 1.0", ["error"]),
        ("EffortJointInterface", "max_velocity: 1.0, has_velocity_limits: true, has_effort_limits: false", ["error"]),
        ("PositionJointInterface", "max_velocity: 1.0", ["warning"]),
        ("VelocityJointInterface", "has_velocity_limits: true, max_velocity: 1.0", []),
    ],
)
def test_a_joint_without_limit_in_the_urdf_needs_what_its_interface_enforces(
    bench: Bench, interface: str, limits: str, told: list[str]
) -> None:
    robot = (
        '<robot name="arm"><link name="a"/><link name="b"/><joint name="elbow" type="continuous"><parent link="a"/>'
        f'<child link="b"/></joint>{transmission("elbow", interface)}{GAZEBO}</robot>'
    )
    found = bench.lint(robot, f"{STATE_CONTROLLER}joint_limits:\n  elbow: {{{limits}}}\n", distro="noetic")
    assert [finding.severity.value for finding in found if finding.code == "UC468"] == told


def test_a_number_that_is_not_said_to_count_is_told(bench: Bench) -> None:
    yaml = STATE_CONTROLLER + "joint_limits:\n  elbow: {max_velocity: 1.0}\n"
    assert bench.says(transmission("elbow") + GAZEBO, yaml, distro="noetic") == [
        "warning UC468 'max_velocity' of joint 'elbow' is ignored without 'has_velocity_limits: true'"
    ]


def test_gains_of_a_joint_that_needs_none_or_that_nobody_drives_are_told(bench: Bench) -> None:
    yaml = STATE_CONTROLLER + "gazebo_ros_control:\n  pid_gains:\n    elbow: {p: 1.0}\n    elbwo: {p: 1.0}\n"
    assert bench.says(transmission("elbow", "EffortJointInterface") + GAZEBO, yaml, distro="noetic") == [
        "info UC469 gains of joint 'elbow' are ignored: its EffortJointInterface uses none",
        (
            "warning UC469 gains of 'elbwo' are ignored: no transmission drives a joint of this name; "
            "did you mean 'elbow'?"
        ),
    ]
    assert bench.says(transmission("elbow"), yaml, distro="noetic", simulator="none") == []


def test_states_have_no_controller_to_command_them(bench: Bench) -> None:
    assert bench.says(component(joint("elbow", STATES)), controllers("states", kind=FORWARD)) == []


@pytest.mark.parametrize(
    ("name", "meant"), [("elbov", "elbow"), ("Elbow", "elbow"), ("grip", None), ("shoulder", None), ("elbow2", None)]
)
def test_a_joint_of_a_robot_that_is_only_partly_here_is_compared_with_the_known_ones(
    name: str, meant: str | None, tmp_path: Path
) -> None:
    include = '<xacro:include filename="$(find other_arm)/hand.xacro"/>'
    robot = f'<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">{include}<link name="base"/>{ARM}</robot>'
    (tmp_path / "arm.xacro").write_text(robot)
    (tmp_path / "c.yaml").write_text(controllers("arm") + forward("arm", f"shoulder, {name}"))
    target = Target(str(tmp_path / "arm.xacro"), controllers=(str(tmp_path / "c.yaml"),))
    told = [one.message for one in findings(target, ("UC440",), distro="jazzy")]
    message = f"controller 'arm' names joint '{name}', but the part of the robot that is here has '{meant}'"
    assert told == ([message] if meant else [])
