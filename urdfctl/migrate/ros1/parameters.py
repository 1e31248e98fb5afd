"""What becomes of the parameters of ROS 1's controllers in ROS 2, beyond the type of the controller."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from urdfctl.startup.records import NamedTuple

_JTC = "joint_trajectory_controller/JointTrajectoryController"
_DIFF = "diff_drive_controller/DiffDriveController"
_FORWARD = "forward_command_controller/ForwardCommandController"
_PID = "pid_controller/PidController"
MECANUM = "mecanum_drive_controller/MecanumDriveController"
_BROADCASTER = "joint_state_broadcaster/JointStateBroadcaster"


class ParameterChange(NamedTuple):
    """What becomes of a parameter.

    name: its new name, in which `<>` stands for the part of the old one; empty if it is dropped.
    why: why it is dropped; or what the user has to know.
    as_list: whether its value is always a list in ROS 2.
    """

    name: str = ""
    why: str = ""
    as_list: bool = False


_RATE = "the controller runs at the update rate of the manager"
_CHANGES: Mapping[str, Mapping[str, ParameterChange]] = {
    _DIFF: {
        "left_wheel": ParameterChange("left_wheel_names", as_list=True),
        "right_wheel": ParameterChange("right_wheel_names", as_list=True),
        "wheel_radius_multiplier": ParameterChange("left_wheel_radius_multiplier right_wheel_radius_multiplier"),
        "publish_cmd": ParameterChange("publish_limited_velocity"),
        "publish_wheel_joint_controller_state": ParameterChange(why="ros2_controllers does not publish it"),
        "allow_multiple_cmd_vel_publishers": ParameterChange(why="ROS 2 does not count the publishers of a topic"),
        "velocity_rolling_window_size": ParameterChange("velocity_rolling_window_size"),
    },
    _JTC: {
        "state_publish_rate": ParameterChange("state_publish_rate"),
        "velocity_ff.<>": ParameterChange("gains.<>.ff_velocity_scale"),
        "stop_trajectory_duration": ParameterChange(why="the controller holds the position at once"),
        "hold_trajectory_duration": ParameterChange(why="the controller holds the position at once"),
        "verbose": ParameterChange(why="use the log level"),
    },
    _BROADCASTER: {"publish_rate": ParameterChange(why=_RATE)},
    "imu_sensor_broadcaster/IMUSensorBroadcaster": {"publish_rate": ParameterChange(why=_RATE)},
    "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster": {"publish_rate": ParameterChange(why=_RATE)},
    _FORWARD: {"joint": ParameterChange("joints", as_list=True), "publish_rate": ParameterChange(why=_RATE)},
    _PID: {
        "joint": ParameterChange("dof_names", as_list=True),
        "joints": ParameterChange("dof_names", as_list=True),
        "publish_rate": ParameterChange(why=_RATE),
    },
    MECANUM: {
        "front_left_wheel_joint": ParameterChange("front_left_wheel_command_joint_name"),
        "front_right_wheel_joint": ParameterChange("front_right_wheel_command_joint_name"),
        "back_right_wheel_joint": ParameterChange("rear_right_wheel_command_joint_name"),
        "back_left_wheel_joint": ParameterChange("rear_left_wheel_command_joint_name"),
        "wheel_radius": ParameterChange("kinematics.wheels_radius"),
        "cmd_vel_timeout": ParameterChange("reference_timeout"),
        "publish_rate": ParameterChange(why=_RATE),
    },
    "ackermann_steering_controller/AckermannSteeringController": {
        "rear_wheel": ParameterChange("traction_joints_names", as_list=True),
        "front_steer": ParameterChange("steering_joints_names", as_list=True),
        "wheel_separation_h": ParameterChange("wheelbase"),
    },
}
"""By type of ROS 2: the changes of parameters. Others keep their name if the type has a parameter of that name."""

_PID_REFERENCES = {
    "effort_controllers/JointPositionController": ("effort", "position"),
    "effort_controllers/JointGroupPositionController": ("effort", "position"),
    "effort_controllers/JointVelocityController": ("effort", "velocity"),
    "velocity_controllers/JointPositionController": ("velocity", "position"),
}
"""The command interface and the reference of ROS 1's controllers with a PID loop."""


def changes_of(kind: str) -> Mapping[str, ParameterChange]:
    """Return the changes of the parameters of a controller that has this type in ROS 2."""
    return _CHANGES.get(kind, {})


def changed(name: str, changes: Mapping[str, ParameterChange]) -> tuple[ParameterChange, str] | None:
    """Return the change of a parameter, and the part of its name that `<>` stands for; None if it has none."""
    if name in changes:
        return changes[name], ""
    for pattern, change in changes.items():
        before, mark, after = pattern.partition("<>")
        if mark and name.startswith(before) and name.endswith(after) and len(name) > len(before) + len(after):
            return change, name[len(before) : len(name) - len(after)]
    return None


def pid_settings(ros1_type: str, gains: Mapping[str, Sequence[tuple[str, str]]]) -> list[str]:
    """Return the lines of a pid_controller that does what a controller with a PID loop did.

    gains: the gains of each joint, names and values as written.
    """
    if ros1_type not in _PID_REFERENCES:
        return []
    command, reference = _PID_REFERENCES[ros1_type]
    lines = [f"command_interface: {command}", f"reference_and_state_interfaces: [{reference}]"]
    lines += ["gains:"] if any(gains.values()) else []
    for joint, own in gains.items():
        lines += [f"  {joint}:", *(f"    {name}: {value}" for name, value in own)] if own else []
    return lines
