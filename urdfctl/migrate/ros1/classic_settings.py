"""Plugins of gazebo_ros_pkgs for ROS 1, each with its successor for ROS 2 and the names of its settings there."""

from __future__ import annotations

import re
from collections.abc import Mapping

from urdfctl.startup.records import NamedTuple


class Successor(NamedTuple):
    """The plugin of ROS 2 for one of ROS 1.

    library: its library, without `lib` and `.so`.
    settings: for each setting of ROS 1, its names in ROS 2. Several names get the value each.
    topics: for each setting of ROS 1 with a topic, the topic of the plugin in ROS 2, which is remapped.
    added: settings that ROS 1's plugin has no name for, and those whose defaults differ: written if nothing sets them.
    values: new values by the name of a setting in ROS 2, for those that are written otherwise.
    camera: whether its topics begin with the name of the camera.
    lists: settings that ROS 1 separates by commas, and ROS 2 writes one by one.
    """

    library: str
    settings: Mapping[str, tuple[str, ...]]
    topics: Mapping[str, str] = {}
    added: tuple[tuple[str, str], ...] = ()
    values: Mapping[str, Mapping[str, str]] = {}
    camera: bool = False
    lists: tuple[str, ...] = ()


def snake_case(name: str) -> str:
    """Return a name in camel case as ROS 2 writes it."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def _same(words: str = "", **others: str) -> dict[str, tuple[str, ...]]:
    """Return settings with their names in ROS 2: the same in snake case, or new ones."""
    return {**{name: (snake_case(name),) for name in words.split()}, **{name: (new,) for name, new in others.items()}}


_ODOMETRY = _same("odometryFrame robotBaseFrame updateRate covariance_x covariance_y covariance_yaw")
_DRIVE_TOPICS = {"commandTopic": "cmd_vel", "odometryTopic": "odom"}
_SOURCES = {"odometry_source": {"encoder": "0", "world": "1"}}
_PUBLISHED = (("publish_odom", "true"), ("publish_odom_tf", "true"))
_PAIRS = ("num_wheel_pairs", "2")
_OF_CAMERA = {
    "imageTopicName": "image_raw",
    "cameraInfoTopicName": "camera_info",
    "depthImageTopicName": "depth/image_raw",
    "depthImageCameraInfoTopicName": "depth/camera_info",
    "depthImageInfoTopicName": "depth/camera_info",
    "pointCloudTopicName": "points",
}
_CAMERA = Successor(
    "gazebo_ros_camera",
    _same("cameraName frameName hackBaseline", pointCloudCutoff="min_depth", pointCloudCutoffMax="max_depth"),
    _OF_CAMERA,
    camera=True,
)
_POSE = _same("bodyName frameName gaussianNoise updateRate xyzOffset rpyOffset")
_POSE |= _same(rpyOffsets="rpy_offset", xyzOffsets="xyz_offset")


def _ray(output: str, **others: str) -> Successor:
    given = ("output_type", f"sensor_msgs/{output}")
    return Successor("gazebo_ros_ray_sensor", _same("frameName", **others), {"topicName": "~/out"}, (given,))


SUCCESSORS: Mapping[str, Successor] = {
    "gazebo_ros_diff_drive": Successor(
        "gazebo_ros_diff_drive",
        _ODOMETRY
        | _same("leftJoint rightJoint wheelSeparation wheelDiameter odometrySource publishWheelTF")
        | _same("publishOdomTF", publishTf="publish_odom_tf", wheelTorque="max_wheel_torque")
        | _same(wheelAcceleration="max_wheel_acceleration"),
        _DRIVE_TOPICS,
        _PUBLISHED,
        _SOURCES,
    ),
    "gazebo_ros_skid_steer_drive": Successor(
        "gazebo_ros_diff_drive",
        _ODOMETRY
        | _same(leftFrontJoint="left_joint", leftRearJoint="left_joint", rightFrontJoint="right_joint")
        | _same(rightRearJoint="right_joint", torque="max_wheel_torque", broadcastTF="publish_odom_tf")
        | {name: (snake_case(name),) * 2 for name in ("wheelSeparation", "wheelDiameter")},
        _DRIVE_TOPICS,
        (_PAIRS, *_PUBLISHED),
    ),
    "gazebo_ros_planar_move": Successor(
        "gazebo_ros_planar_move",
        _ODOMETRY | _same(odometryRate="publish_rate"),
        _DRIVE_TOPICS,
        _PUBLISHED,
    ),
    "gazebo_ros_tricycle_drive": Successor(
        "gazebo_ros_tricycle_drive",
        _ODOMETRY
        | _same("steeringJoint actuatedWheelJoint encoderWheelLeftJoint encoderWheelRightJoint")
        | _same("actuatedWheelDiameter encoderWheelDiameter odometrySource publishWheelTF")
        | _same("publishWheelJointState", encoderWheelSeparation="wheel_separation", wheelTorque="max_wheel_torque")
        | _same(wheelAcceleration="max_wheel_acceleration", wheelDeceleration="max_wheel_deceleration")
        | _same(wheelSpeedTolerance="max_wheel_speed_tolerance", steeringSpeed="max_steering_speed")
        | _same(steeringAngleTolerance="max_steering_angle_tolerance"),
        _DRIVE_TOPICS,
        (("publish_odom", "true"),),
        _SOURCES,
    ),
    "gazebo_ros_joint_state_publisher": Successor(
        "gazebo_ros_joint_state_publisher",
        _same("updateRate jointName"),
        {"topicName": "joint_states"},
        lists=("joint_name",),
    ),
    "gazebo_ros_p3d": Successor("gazebo_ros_p3d", _POSE, {"topicName": "odom"}),
    "gazebo_ros_ft_sensor": Successor(
        "gazebo_ros_ft_sensor", _same("jointName gaussianNoise updateRate"), {"topicName": "wrench"}
    ),
    "gazebo_ros_bumper": Successor(
        "gazebo_ros_bumper", _same("frameName"), {"bumperTopicName": "bumper_states", "topicName": "bumper_states"}
    ),
    "gazebo_ros_imu_sensor": Successor(
        "gazebo_ros_imu_sensor", _same("frameName initialOrientationAsReference"), {"topicName": "~/out"}
    ),
    "gazebo_ros_laser": _ray("LaserScan"),
    "gazebo_ros_gpu_laser": _ray("LaserScan"),
    "gazebo_ros_block_laser": _ray("PointCloud"),
    "gazebo_ros_range": _ray("Range", radiation="radiation_type"),
    **dict.fromkeys(
        (
            "gazebo_ros_camera",
            "gazebo_ros_depth_camera",
            "gazebo_ros_openni_kinect",
            "gazebo_ros_multicamera",
            "gazebo_ros_prosilica",
            "gazebo_ros_triggered_camera",
            "gazebo_ros_triggered_multicamera",
        ),
        _CAMERA,
    ),
}
"""By library of ROS 1, without `lib` and `.so` (gazebo_plugins, the header files of both branches)."""

OF_SENSOR = ("updateRate", "updateRateHZ")
"""Settings of a plugin in ROS 1 that belong to its sensor in ROS 2."""
