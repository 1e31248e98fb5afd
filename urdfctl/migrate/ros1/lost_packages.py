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
    "costmap_2d": "nav2_costmap_2d",
    "dwa_local_planner": _NAV2,
    "dynamic_reconfigure": "the parameters of a node",
    "eigen_conversions": "tf2_eigen",
    "freenect_launch": "",
    "global_planner": _NAV2,
    "gmapping": "slam_toolbox",
    "hector_gazebo_plugins": "the sensors of the simulator",
    "hector_slam": "slam_toolbox",
    "joint_limits_interface": "joint_limits",
    "kdl_conversions": "tf2_kdl",
    "moveit_commander": "moveit_py",
    "nav_core": "nav2_core",
    "navfn": "nav2_navfn_planner",
    "nodelet": "rclcpp_components",
    "openni_launch": "",
    "openni2_launch": "openni2_camera",
    "robot_pose_ekf": "robot_localization",
    "rosconsole": "the logging of rclpy or rclcpp",
    "rosserial": "micro-ROS",
    "rosserial_arduino": "micro-ROS",
    "rosserial_python": "micro-ROS",
    "rotate_recovery": _NAV2,
    "tf_conversions": "tf_transformations",
}
"""By name in ROS 1: what does its work in ROS 2; empty if nothing does."""


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
