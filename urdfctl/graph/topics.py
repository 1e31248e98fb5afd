"""The topics and actions of the controllers of ros_controllers and ros2_controllers, by type.

From the sources of the controllers: `create_subscription`, `create_publisher`, `create_server` (ROS 2), `subscribe`,
`advertise` and `SimpleActionServer` (ROS 1). A name that begins with `~/` is below the controller's own name. What only
reports the controller's inner state is left out.
"""

from __future__ import annotations

from collections.abc import Mapping

from urdfctl.catalog.distros import generation
from urdfctl.startup.records import NamedTuple


class Topics(NamedTuple):
    """What a controller subscribes to, the actions that it serves, and what it publishes."""

    subscribes: tuple[str, ...] = ()
    actions: tuple[str, ...] = ()
    publishes: tuple[str, ...] = ()


NO_TOPICS = Topics()
_COMMANDS, _REFERENCE = Topics(("~/commands",)), Topics(("~/reference",))
_STEERED = Topics(("~/reference",), (), ("~/odometry", "~/tf_odometry"))
_GRIPPER = Topics((), ("~/gripper_cmd",))
_DRIVEN = Topics(("~/cmd_vel",), (), ("~/odom", "/tf"))
_ROS2: Mapping[str, Topics] = {
    "joint_trajectory_controller/JointTrajectoryController": Topics(
        ("~/joint_trajectory",), ("~/follow_joint_trajectory",)
    ),
    "forward_command_controller/ForwardCommandController": _COMMANDS,
    "forward_command_controller/MultiInterfaceForwardCommandController": _COMMANDS,
    "position_controllers/JointGroupPositionController": _COMMANDS,
    "velocity_controllers/JointGroupVelocityController": _COMMANDS,
    "effort_controllers/JointGroupEffortController": _COMMANDS,
    "diff_drive_controller/DiffDriveController": _DRIVEN,
    "omni_wheel_drive_controller/OmniWheelDriveController": _DRIVEN,
    "tricycle_controller/TricycleController": _DRIVEN,
    "mecanum_drive_controller/MecanumDriveController": _STEERED,
    "ackermann_steering_controller/AckermannSteeringController": _STEERED,
    "bicycle_steering_controller/BicycleSteeringController": _STEERED,
    "tricycle_steering_controller/TricycleSteeringController": _STEERED,
    "pid_controller/PidController": _REFERENCE,
    "admittance_controller/AdmittanceController": Topics(("~/joint_references",)),
    "gpio_controllers/GpioCommandController": Topics(("~/commands",), (), ("~/gpio_states",)),
    "position_controllers/GripperActionController": _GRIPPER,
    "effort_controllers/GripperActionController": _GRIPPER,
    "parallel_gripper_action_controller/GripperActionController": _GRIPPER,
    "joint_state_broadcaster/JointStateBroadcaster": Topics((), (), ("/joint_states", "/dynamic_joint_states")),
    "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster": Topics((), (), ("~/wrench",)),
    "imu_sensor_broadcaster/IMUSensorBroadcaster": Topics((), (), ("~/imu",)),
    "pose_broadcaster/PoseBroadcaster": Topics((), (), ("~/pose",)),
    "range_sensor_broadcaster/RangeSensorBroadcaster": Topics((), (), ("~/range",)),
    "gps_sensor_broadcaster/GPSSensorBroadcaster": Topics((), (), ("~/gps/fix",)),
    "magnetometer_broadcaster/MagnetometerBroadcaster": Topics((), (), ("~/magnetic_field",)),
    "battery_state_broadcaster/BatteryStateBroadcaster": Topics((), (), ("~/battery_state",)),
    "state_interfaces_broadcaster/StateInterfacesBroadcaster": Topics((), (), ("~/names", "~/values")),
}
_COMMAND1 = Topics(("~/command",))
_DRIVEN1 = Topics(("~/cmd_vel",), (), ("~/odom", "/tf"))
_ROS1: Mapping[str, Topics] = {
    **{
        f"{package}_controllers/Joint{kind}Controller": _COMMAND1
        for package in ("effort", "velocity", "position")
        for kind in ("Position", "Velocity", "Effort", "GroupPosition", "GroupVelocity", "GroupEffort")
    },
    **{
        f"{package}_controllers/JointTrajectoryController": Topics(("~/command",), ("~/follow_joint_trajectory",))
        for package in ("position", "velocity", "effort", "pos_vel", "pos_vel_acc")
    },
    "position_controllers/GripperActionController": _GRIPPER,
    "effort_controllers/GripperActionController": _GRIPPER,
    "diff_drive_controller/DiffDriveController": _DRIVEN1,
    "ackermann_steering_controller/AckermannSteeringController": _DRIVEN1,
    "four_wheel_steering_controller/FourWheelSteeringController": Topics(
        ("~/cmd_vel", "~/cmd_four_wheel_steering"), (), ("~/odom", "/tf")
    ),
    "joint_state_controller/JointStateController": Topics((), (), ("/joint_states",)),
}
_OLD = ("foxy", "galactic")


def topics_of(kind: str | None, distro: str, values: Mapping[str, object]) -> Topics:
    """Return the topics and actions of a controller; none if its type is not known.

    values: its parameters by name.
    """
    found = (_ROS1 if generation(distro) == 1 else _ROS2).get(kind or "", NO_TOPICS)
    if values.get("use_local_topics") is True:
        found = found._replace(publishes=tuple(f"~{name}" for name in found.publishes))
    if values.get("use_stamped_vel") is False and found.subscribes == ("~/cmd_vel",) and "diff" in (kind or ""):
        found = found._replace(subscribes=("~/cmd_vel_unstamped",))
    if distro in _OLD and found is _DRIVEN:
        found = found._replace(publishes=("/odom", "/tf"))
    return found
