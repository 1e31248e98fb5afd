"""The gz names of Gazebo Classic plugins."""

from __future__ import annotations

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
"""By the name of the library, without `lib` and `.so`."""
