"""Which launch files of packages that are not here seem to start a robot: their names say it."""

from __future__ import annotations

import re

from urdfctl.source.opaque import OUTSIDE

_PACKAGE = (
    r"(?:bringup|moveit\d?|moveit\d?_config|gazebo|ignition|gz|sim|simulation|simulator|description|robot_driver|"
    r"(?:ros2?_)?control|controllers?|robot|arm|launch)"
)
_FILE = r"(?:bringup|moveit|move_group|(?:ros2?_)?control|controllers?|spawn|demo|robot|arm|simulation)"
_WITHOUT_ROBOTS = (
    r"(?:gazebo_ros|ros_gz_sim|ros_ign_gazebo|nav2_\w+|nav_\w+|slam_\w+|rtabmap\w*|robot_localization|cartographer\w*|"
    r"realsense\w*|velodyne\w*|\w*(?:camera|lidar|teleop|joy)\w*)"
)
_FOUND = r"\$\(find(?:-pkg-share)?\s+[\"']?([\w-]+)[\"']?\)"


def may_start_robot(package: str, file: str) -> bool:
    """Return whether a launch file of a package, by its path or its name, seems to start a robot."""
    if re.fullmatch(_WITHOUT_ROBOTS, package):
        return False
    name = re.split(r"[/\\]", file)[-1].partition(".")[0]
    is_named = re.search(rf"(?:^|_|-){_FILE}(?:$|_|-|\d)", name) is not None
    return is_named or re.search(rf"(?:^|_){_PACKAGE}$", package) is not None


def package_of(address: str) -> str | None:
    """Return the package that the address of an included file names; None if it names none."""
    found = re.search(rf"{OUTSIDE}|{_FOUND}", address)
    return (found[1] or found[2]) if found else None
