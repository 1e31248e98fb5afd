"""Rules on a controller's parameters together, and on the types of their values."""

from __future__ import annotations

import pytest

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.entries import ParameterEntry
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.parameters.rules import breaches
from urdfctl.source.opaque import UNKNOWN

JTC = "joint_trajectory_controller/JointTrajectoryController"
STATES = "must be one of these combinations: position; position, velocity; position, velocity, acceleration"
TRACKING = "gains.a.tracking_time_constant"
PID_ARM = {
    "joints": ["a"],
    "command_interfaces": ["effort"],
    "state_interfaces": ["position", "velocity"],
    "gains.a.p": 1.0,
}
ARM = {"joints": ["a", "b"], "command_interfaces": ["position"], "state_interfaces": ["position", "velocity"]}


def said(kind: str, distro: str, values: dict[str, object]) -> list[str]:
    controller = CATALOG.controller(kind, distro)
    assert controller is not None
    return [f"{found.rule.severity}: {found.parameter} {found.message}" for found in breaches(controller, values)]


@pytest.mark.parametrize(
    ("kind", "distro", "values", "expected"),
    [
        (JTC, "jazzy", ARM, []),
        (JTC, "jazzy", {**ARM, "command_interfaces": ["velocity", "position"]}, []),
        (
            JTC,
            "jazzy",
            {**ARM, "state_interfaces": ["velocity"]},
            [f"error: state_interfaces {STATES}"],
        ),
        (
            JTC,
            "jazzy",
            {**ARM, "command_interfaces": ["velocity"], "state_interfaces": ["position"], "gains.a.p": 1.0},
            ["error: state_interfaces must contain 'velocity' if 'command_interfaces' is velocity"],
        ),
        (JTC, "jazzy", {**ARM, "command_interfaces": ["velocity"]}, []),
        (JTC, "jazzy", {**ARM, "command_joints": ["x", "y"]}, []),
        (
            JTC,
            "jazzy",
            {**ARM, "command_joints": ["c"]},
            ["error: command_joints can contain only elements of 'joints', not 'c'"],
        ),
        (
            JTC,
            "humble",
            {**ARM, "command_joints": ["a"]},
            ["error: command_joints must have as many elements as 'joints' (2), not 1"],
        ),
        (
            JTC,
            "humble",
            {"joints": ["a"], "command_interfaces": ["position"]},
            ["error: state_interfaces must not be empty"],
        ),
        (
            JTC,
            "jazzy",
            {**ARM, "cmd_timeout": 0.5, "constraints.goal_time": 1.0},
            ["warning: cmd_timeout must be greater than 'constraints.goal_time' (1.0), not 0.5"],
        ),
        (
            "bicycle_steering_controller/BicycleSteeringController",
            "rolling",
            {"traction_joints_names": ["a", "b"], "steering_joints_names": ["c"]},
            ["error: traction_joints_names must have exactly 1 element, not 2"],
        ),
        (
            "omni_wheel_drive_controller/OmniWheelDriveController",
            "jazzy",
            {"wheel_names": ["a", "b"]},
            ["error: wheel_names must have at least 3 elements, not 2"],
        ),
        (JTC, "jazzy", {**ARM, "gains.a.u_clamp_max": -1.0, "gains.a.u_clamp_min": 1.0}, []),  # runs no PID
        (
            JTC,
            "jazzy",
            {**PID_ARM, "gains.a.u_clamp_max": 0.0, "gains.a.u_clamp_min": 0.0},
            ["error: gains.a.u_clamp_max must be greater than 'gains.a.u_clamp_min' (0.0), not 0.0"],
        ),
        (
            JTC,
            "kilted",
            {**PID_ARM, "gains.a.i_clamp_max": -1.0},
            ["error: gains.a.i_clamp_max must be ≥ 0.0, not -1.0"],
        ),
        (JTC, "humble", {**PID_ARM, "gains.a.i_clamp": -1.0}, ["error: gains.a.i_clamp must be ≥ 0.0, not -1.0"]),
        (
            JTC,
            "jazzy",
            {**PID_ARM, "gains.a.antiwindup_strategy": "back_calculation", TRACKING: -1.0},
            [f"error: {TRACKING} must be ≥ 0.0 if 'gains.a.antiwindup_strategy' is back_calculation, not -1.0"],
        ),
        (JTC, "jazzy", {**PID_ARM, TRACKING: -1.0}, []),
        (
            "pid_controller/PidController",
            "jazzy",
            {"dof_names": ["a"], "reference_and_state_interfaces": ["position", "position"], "gains.a.p": 1.0},
            ["error: reference_and_state_interfaces must not contain duplicates"],
        ),
        (
            "ackermann_steering_controller/AckermannSteeringController",
            "kilted",
            {
                "traction_joints_names": ["a", "b"],
                "steering_joints_names": ["c", "d"],
                "velocity_rolling_window_size": 0,
            },
            ["error: velocity_rolling_window_size must not be 0"],
        ),
        (
            "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster",
            "jazzy",
            {"frame_id": "f"},
            ["error: sensor_name or 'interface_names.*' is required"],
        ),
        (
            "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster",
            "jazzy",
            {"frame_id": "f", "sensor_name": "s", "interface_names.force.x": "s/force.x"},
            ["error: sensor_name cannot be combined with 'interface_names.*'"],
        ),
        (
            "parallel_gripper_action_controller/GripperActionController",
            "jazzy",
            {"joint": "finger", "max_effort_interface": "effort"},
            ["error: max_effort_interface must be a full name such as 'finger/effort', not 'effort'"],
        ),
        (
            "pid_controller/PidController",
            "jazzy",
            {"dof_names": ["a", "$(var b)"], "gains.a.u_clamp_max": -2.0, "gains.a.u_clamp_min": -1.0},
            ["error: gains.a.u_clamp_max must be greater than 'gains.a.u_clamp_min' (-1.0), not -2.0"],
        ),
        (
            "diff_drive_controller/DiffDriveController",
            "noetic",
            {"left_wheel": "l", "right_wheel": ["r", "s"], "linear.x.has_jerk_limits": True},
            [
                "warning: linear.x.max_jerk is required if 'linear.x.has_jerk_limits' is true",
                "warning: linear.x.max_jerk must be > 0.0, not 0.0",
                "error: right_wheel must have as many elements as 'left_wheel' (1), not 2",
            ],
        ),
    ],
)
def test_a_rule_that_is_broken_is_told(kind: str, distro: str, values: dict[str, object], expected: list[str]) -> None:
    assert sorted(said(kind, distro, values)) == sorted(expected)


@pytest.mark.parametrize("unknown", ["$(var x)", UNKNOWN, ["a", "$(var x)"]])
def test_what_is_not_known_breaks_no_rule(unknown: object) -> None:
    assert said(JTC, "jazzy", dict.fromkeys((*ARM, "command_joints", "cmd_timeout"), unknown)) == []
    wheels = dict.fromkeys(("left_wheel_names", "right_wheel_names"), unknown)
    assert said("diff_drive_controller/DiffDriveController", "jazzy", {**wheels, "left_wheel_names": ["a"]}) == []


@pytest.mark.parametrize(
    ("kind", "value", "distro", "expected"),
    [
        ("double", 1.0, "jazzy", None),
        ("double", 1, "jazzy", "must be a number with a decimal point, not the integer 1"),
        ("double", 1, "foxy", None),
        ("double", 1, "noetic", None),
        ("double", "1", "noetic", "must be a number, not the string '1'"),
        ("int", 1.5, "noetic", None),
        ("int", 1.5, "jazzy", "must be an integer, not the number 1.5"),
        ("int", True, "jazzy", "must be an integer, not true"),
        ("bool", "yes", "jazzy", "must be true or false, not the string 'yes'"),
        ("string", 1, "jazzy", "must be a string, not the integer 1"),
        ("string_array", "a", "jazzy", "must be a list of strings, not the string 'a'"),
        ("string_array", [1, "a"], "jazzy", "must be a list of strings, not a list of integers and strings"),
        ("string_array", [], "jazzy", None),
        (
            "string_array",
            [[], {}, None],
            "jazzy",
            "must be a list of strings, not a list of lists and maps and empty elements",
        ),
        ("double_array", [0, 1], "jazzy", "must be a list of numbers with a decimal point, not a list of integers"),
        ("double_array", [True], "noetic", "must be a list of numbers, not a list of booleans"),
        ("string | string_array", "a", "noetic", None),
        ("string | string_array", [1.0], "noetic", "must be a string or a list of strings, not a list of numbers"),
        ("int", {"a": 1}, "jazzy", "must be an integer, not a map"),
        ("int", [], "jazzy", "must be an integer, not an empty list"),
        ("int", None, "jazzy", "must be an integer, not empty"),
        ("int", "$(var n)", "jazzy", None),
        ("none", {"a": 1}, "jazzy", None),
    ],
)
def test_a_value_of_another_type_is_told_as_its_reader_sees_it(
    kind: str, value: object, distro: str, expected: str | None
) -> None:
    assert type_problem(value, ParameterEntry("p", kind), distro) == expected


def test_a_covariance_of_ros_1_takes_no_integer() -> None:
    parameter = ParameterEntry("pose_covariance_diagonal", "double_array", floats_only=True)
    assert type_problem([0.0, 0], parameter, "noetic") == (
        "must be a list of numbers with a decimal point, not a list of numbers and integers"
    )


DRIVE = "diff_drive_controller/DiffDriveController"


@pytest.mark.parametrize(
    ("distro", "values", "expected"),
    [
        ("jazzy", {"linear.x.max_velocity": 0.0}, ["warning: linear.x.max_velocity must not be 0"]),
        ("jazzy", {"linear.x.max_velocity": 0.0, "linear.x.has_velocity_limits": False}, []),
        ("humble", {"linear.x.max_jerk": 0.0}, []),
        ("kilted", {"angular.z.max_jerk": 0.0}, ["warning: angular.z.max_jerk must not be 0"]),
        ("rolling", {"angular.z.max_acceleration": float("nan")}, []),
        ("noetic", {"linear.x.max_velocity": 0.0}, []),
        (
            "noetic",
            {"linear.x.max_velocity": -1.0, "linear.x.has_velocity_limits": True},
            ["warning: linear.x.max_velocity must be > 0.0, not -1.0"],
        ),
    ],
)
def test_a_base_whose_limit_is_0_stands_still_if_the_limit_is_read(
    distro: str, values: dict[str, object], expected: list[str]
) -> None:
    wheels = {"left_wheel_names": ["l"], "right_wheel_names": ["r"], "left_wheel": "l", "right_wheel": "r"}
    assert said(DRIVE, distro, {**wheels, **values}) == expected


@pytest.mark.parametrize(
    ("kind", "distro", "name", "harmful", "sound"),
    [
        (DRIVE, "humble", "cmd_vel_timeout", 0.0, 0.1),
        (DRIVE, "noetic", "cmd_vel_timeout", 0.0, 0.1),
        (DRIVE, "jazzy", "wheel_separation_multiplier", 0.0, 1.1),
        (DRIVE, "noetic", "wheel_radius_multiplier", -1.0, 1.0),
        ("omni_wheel_drive_controller/OmniWheelDriveController", "jazzy", "cmd_vel_timeout", -1.0, 1.0),
        ("mecanum_drive_controller/MecanumDriveController", "jazzy", "reference_timeout", -1.0, 0.0),
        (JTC, "jazzy", "gains.<joints>.p", -1.0, 0.0),
        (JTC, "humble", "constraints.<joints>.goal", -0.1, 0.0),
        ("pid_controller/PidController", "jazzy", "gains.<dof_names>.i", -1.0, 1.0),
    ],
)
def test_a_value_that_is_accepted_and_stops_or_endangers_the_robot_is_known(
    kind: str, distro: str, name: str, harmful: float, sound: float
) -> None:
    controller = CATALOG.controller(kind, distro)
    assert controller is not None
    useful = controller.parameters[name].useful
    assert problem(harmful, useful) is not None
    assert problem(sound, useful) is None
