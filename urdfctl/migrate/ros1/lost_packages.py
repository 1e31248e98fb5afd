"""Dependencies of package.xml that no distro of ROS 2 has."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.migrate.edits.markup import content
from urdfctl.migrate.step import EntryKind, ReportEntry
from urdfctl.source.xml.dom import Element

AUTHORITY = "docs.ros.org, Migrating Packages: all dependencies must be available in ROS 2"
_NAV2 = "the packages of nav2"
_LOST: Mapping[str, str] = {
    "actionlib": "the actions of rclpy, or rclcpp_action",
    "ar_track_alvar": "",
    "base_local_planner": _NAV2,
    "clear_costmap_recovery": _NAV2,
    "combined_robot_hw": "several <ros2_control> elements",
    "costmap_2d": "nav2_costmap_2d",
    "dwa_local_planner": _NAV2,
    "dynamic_reconfigure": "the parameters of a node",
    "eigen_conversions": "tf2_eigen",
    "fake_localization": "",
    "freenect_camera": "",
    "freenect_launch": "",
    "global_planner": _NAV2,
    "gmapping": "slam_toolbox",
    "hector_gazebo": "the sensors of the simulator",
    "hector_gazebo_plugins": "the sensors of the simulator",
    "hector_mapping": "slam_toolbox",
    "hector_slam": "slam_toolbox",
    "joint_limits_interface": "joint_limits",
    "joint_trajectory_action": "joint_trajectory_controller",
    "kdl_conversions": "tf2_kdl",
    "move_base_msgs": "nav2_msgs",
    "moveit_commander": "moveit_py",
    "nav_core": "nav2_core",
    "navfn": "nav2_navfn_planner",
    "navigation": "navigation2",
    "nodelet": "rclcpp_components",
    "openni2_launch": "openni2_camera",
    "openni_launch": "",
    "robot_pose_ekf": "robot_localization",
    "rosconsole": "the logging of rclpy or rclcpp",
    "rosserial": "micro-ROS",
    "rosserial_arduino": "micro-ROS",
    "rosserial_client": "micro-ROS",
    "rosserial_msgs": "micro-ROS",
    "rosserial_python": "micro-ROS",
    "rosserial_server": "micro-ROS",
    "rotate_recovery": _NAV2,
    "slam_gmapping": "slam_toolbox",
    "tf_conversions": "tf_transformations",
    "yocs_cmd_vel_mux": "twist_mux",
    "yocs_velocity_smoother": "nav2_velocity_smoother",
}
"""By name in ROS 1: what does its work in ROS 2; empty if nothing does."""


def is_lost(name: str) -> bool:
    """Return whether no distro of ROS 2 has a package of ROS 1."""
    return name in _LOST


def lost_dependencies(elements: list[Element]) -> Iterator[ReportEntry]:
    """Yield an entry for each dependency that ROS 2 does not have, once for each package.

    elements: those of a package.xml that name dependencies.
    """
    told: set[str] = set()
    for element in elements:
        name = content(element)
        if name not in _LOST or name in told:
            continue
        told.add(name)
        instead = f"use {_LOST[name]} in its place" if _LOST[name] else "do without it"
        what = f"dependency '{name}' does not exist in ROS 2: {instead}"
        yield ReportEntry(EntryKind.FOR_YOU, what, element.at, authority=AUTHORITY)
