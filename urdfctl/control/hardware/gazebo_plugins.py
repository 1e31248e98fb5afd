"""Names of Gazebo's plugins in ROS 1, in ROS 2 and in gz, and of renamed settings."""

from __future__ import annotations

_BOTH = (
    "bumper camera diff_drive elevator force ft_sensor hand_of_god harness imu_sensor joint_pose_trajectory "
    "joint_state_publisher p3d planar_move projector template tricycle_drive vacuum_gripper video wheel_slip"
)
_ROS1 = (
    "block_laser depth_camera f3d gpu_laser imu joint_trajectory laser moveit_planning_scene multicamera openni_kinect "
    "prosilica range skid_steer_drive triggered_camera triggered_multicamera"
)
_ROS2 = "ackermann_drive gps_sensor ray_sensor"


def _libraries(words: str) -> frozenset[str]:
    return frozenset(f"gazebo_ros_{word}" for word in words.split())


LIBRARIES = {1: _libraries(f"{_BOTH} {_ROS1}"), 2: _libraries(f"{_BOTH} {_ROS2}")}
"""The libraries of gazebo_plugins by ROS version, without `lib` and `.so`."""

OF_SENSORS = _libraries(
    "block_laser bumper camera depth_camera gpu_laser imu_sensor laser multicamera openni_kinect prosilica range "
    "ray_sensor triggered_camera triggered_multicamera"
)
"""The libraries that only a sensor loads."""

IN_PLACE = {
    1: {
        "gazebo_ros2_control": "libgazebo_ros_control.so",
        "gazebo_ros_gps_sensor": "libhector_gazebo_ros_gps.so",
        "gazebo_ros_ray_sensor": "libgazebo_ros_laser.so",
    },
    2: {
        "gazebo_ros_block_laser": "libgazebo_ros_ray_sensor.so",
        "gazebo_ros_control": "libgazebo_ros2_control.so",
        "gazebo_ros_depth_camera": "libgazebo_ros_camera.so",
        "gazebo_ros_f3d": "libgazebo_ros_ft_sensor.so",
        "gazebo_ros_gpu_laser": "libgazebo_ros_ray_sensor.so",
        "gazebo_ros_imu": "libgazebo_ros_imu_sensor.so",
        "gazebo_ros_joint_trajectory": "libgazebo_ros_joint_pose_trajectory.so",
        "gazebo_ros_laser": "libgazebo_ros_ray_sensor.so",
        "gazebo_ros_multicamera": "libgazebo_ros_camera.so",
        "gazebo_ros_openni_kinect": "libgazebo_ros_camera.so",
        "gazebo_ros_prosilica": "libgazebo_ros_camera.so",
        "gazebo_ros_range": "libgazebo_ros_ray_sensor.so",
        "gazebo_ros_skid_steer_drive": "libgazebo_ros_diff_drive.so",
        "gazebo_ros_triggered_camera": "libgazebo_ros_camera.so",
        "gazebo_ros_triggered_multicamera": "libgazebo_ros_camera.so",
    },
}
"""For each ROS version, the file that replaces a library of the other version in Gazebo Classic."""

DRIVES = frozenset({
    "gazebo_ros_ackermann_drive",
    "gazebo_ros_diff_drive",
    "gazebo_ros_skid_steer_drive",
    "gazebo_ros_tricycle_drive",
    "gz-sim-ackermann-steering-system",
    "gz-sim-diff-drive-system",
    "gz-sim-mecanum-drive-system",
})  # fmt: skip
"""The libraries that drive a vehicle by its wheel joints."""

MOVERS = DRIVES | {
    "gz-sim-joint-controller-system",
    "gz-sim-joint-position-controller-system",
    "gz-sim-joint-trajectory-controller-system",
}
"""The libraries that command joints themselves."""

BECAME = {
    "commandtopic": ("ros/remapping",),
    "controlperiod": ("'update_rate' of the controller manager",),
    "odometryrate": ("publish_rate", "update_rate"),
    "odometrytopic": ("ros/remapping",),
    "robotnamespace": ("ros/namespace",),
    "robotsimtype": ("<plugin> in <hardware> of <ros2_control>",),
    "torque": ("wheelTorque", "max_wheel_torque"),
    "topicname": ("commandTopic", "ros/remapping"),
    "wheelacceleration": ("max_wheel_acceleration",),
    "wheeltorque": ("max_wheel_torque",),
}
"""The names of settings in other plugins, by the name in lower case without underscores.

A name with a space is not a setting: it describes where the value belongs outside of the plugin.
"""

_CONTROL = 'filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"'
_SENSORS = "gz-sim-sensors-system, which belongs in the world file"

IN_GZ = {
    "gazebo_ros2_control": _CONTROL,
    "gazebo_ros_control": _CONTROL,
    "gazebo_ros_ackermann_drive": "gz-sim-ackermann-steering-system",
    "gazebo_ros_bumper": "gz-sim-contact-system, which belongs in the world file",
    "gazebo_ros_camera": _SENSORS,
    "gazebo_ros_depth_camera": _SENSORS,
    "gazebo_ros_diff_drive": "gz-sim-diff-drive-system",
    "gazebo_ros_ft_sensor": "gz-sim-forcetorque-system, which belongs in the world file",
    "gazebo_ros_gps_sensor": "gz-sim-navsat-system, which belongs in the world file",
    "gazebo_ros_gpu_laser": _SENSORS,
    "gazebo_ros_imu": "gz-sim-imu-system, which belongs in the world file",
    "gazebo_ros_imu_sensor": "gz-sim-imu-system, which belongs in the world file",
    "gazebo_ros_joint_pose_trajectory": "gz-sim-joint-trajectory-controller-system",
    "gazebo_ros_joint_state_publisher": "gz-sim-joint-state-publisher-system",
    "gazebo_ros_laser": _SENSORS,
    "gazebo_ros_openni_kinect": _SENSORS,
    "gazebo_ros_p3d": "gz-sim-odometry-publisher-system",
    "gazebo_ros_planar_move": "gz-sim-velocity-control-system",
    "gazebo_ros_range": _SENSORS,
    "gazebo_ros_ray_sensor": _SENSORS,
    "gazebo_ros_skid_steer_drive": "gz-sim-diff-drive-system",
    "gazebo_ros_wheel_slip": "gz-sim-wheel-slip-system",
}
"""The names in gz of the plugins of Gazebo Classic, by the library without `lib` and `.so`."""
