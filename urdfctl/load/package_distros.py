"""Packages that only some distros have, so that who depends on them says what distro it is for."""

from __future__ import annotations

from urdfctl.catalog.distros import spanned

_ROS1_ONLY = (
    "roscpp rospy roslaunch roslib rosbuild gazebo_ros_control ros_control ros_controllers message_generation "
    "message_runtime dynamic_reconfigure nodelet tf actionlib"
)
_ROS2_ONLY = (
    "rclcpp rclpy rclcpp_lifecycle rclcpp_components launch launch_ros ros2launch ros2run "
    "ament_index_python ament_index_cpp ament_lint_auto ros2_control ros2_controllers ros2controlcli "
    "joint_state_broadcaster rosidl_default_generators rosidl_default_runtime tf2_ros_py "
    "generate_parameter_library nav2_bringup"
)
_SPANS = {
    **dict.fromkeys(_ROS1_ONLY.split(), "indigo..noetic"),
    **dict.fromkeys(_ROS2_ONLY.split(), "foxy.."),
    **dict.fromkeys(
        "ros_gz ros_gz_sim ros_gz_bridge ros_gz_image ros_gz_interfaces gz_ros2_control".split(), "humble.."
    ),
    **dict.fromkeys("ros_ign ros_ign_gazebo ros_ign_bridge ros_ign_image".split(), "melodic..noetic, foxy..iron"),
    "gazebo_ros2_control": "foxy..iron",
    "ign_ros2_control": "foxy..jazzy",
}


def distros_of_package(name: str) -> tuple[str, ...]:
    """Return the distros of both generations that have a package; none if all do, or that is unknown."""
    span = _SPANS.get(name)
    return (*spanned(span, 1), *spanned(span, 2)) if span else ()
