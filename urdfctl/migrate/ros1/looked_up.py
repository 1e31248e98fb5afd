"""Packages that migrated files look for and that may not exist in ROS 2: launch, or xacro, ends where they do not."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.migrate.ros1.launch_files import own_packages
from urdfctl.migrate.ros1.lost_packages import is_lost
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry

_AUTHORITY = "ament_index_python get_package_share_directory(): PackageNotFoundError"
_FILES = "xacro: 'No such file or directory'; the descriptions of ROS 2 have other files, for ros2_control"
_LAUNCHES = (".launch.py", ".launch.xml")
_LOOKUP = re.compile(
    r"(?P<source>LaunchDescriptionSource\(\[?\s*)?FindPackageShare\(['\"](?P<share>[\w-]+)['\"]\)"
    r"|(?P<include><include\b[^<>]*\bfile=['\"])?\$\((?:find|find-pkg-share)\s+(?P<find>[\w-]+)\s*\)"
)
"""Where a package is looked for; the launch file of another package is a matter of its own."""
_COMMENT = {".py": r"(?m)#[^\n]*", ".xml": r"(?s)<!--.*?-->"}
_IN_ROS_2 = re.compile(
    r"(?:xacro|urdf|urdf_tutorial|urdf_launch|joy|rviz2|rqt_\w+|tf2_\w+|nav2_\w+|moveit\w*|slam_toolbox|robot_localization"
    r"|robot_state_publisher|joint_state_publisher\w*|controller_manager|\w+_controllers?|\w+_broadcaster|twist_mux"
    r"|teleop_twist_\w+|ros_gz\w*|gz_\w+|gazebo_\w+|ur_\w+|turtlebot3_\w+|franka_description|realsense2_\w+"
    r"|velodyne_(?:description|driver|pointcloud)|diagnostic_aggregator|image_\w+|topic_tools|depth_image_proc)"
)
"""Packages that the distros have; those of Gazebo are told by other steps."""


_INCLUDED = re.compile(r"<xacro:include\b[^<>]*\bfilename=(['\"])\$\(find\s+([\w-]+)\s*\)/([^'\"$]+)\1")
_WITH_SAME_FILES = ("realsense2_description", "velodyne_description", "xacro")
"""Packages whose descriptions have the same files in ROS 2."""


def looked_up_packages(packages: MigratedPackages) -> Iterator[Proposal]:
    """Yield the proposals to tell, for each file, the packages and files that it looks for and that may not exist."""
    yield from _missing_packages(packages)
    own = {*own_packages(packages), *packages.options.successors}
    for path in packages.files(*OF_XML):
        text = packages.read(path).data.decode("utf-8", "replace")
        for found in _INCLUDED.finditer(re.sub(_COMMENT[".xml"], "", text)):
            name, file = found[2], found[3]
            if name not in own and _IN_ROS_2.fullmatch(name) and name not in _WITH_SAME_FILES:
                what = f"check that '{name}' of {packages.options.target} has '{file}', with what the simulator needs"
                entry = ReportEntry(EntryKind.FOR_YOU, what, file=os.path.realpath(path), authority=_FILES)
                yield Proposal(entries=(entry,))


def _missing_packages(packages: MigratedPackages) -> Iterator[Proposal]:
    own = {*own_packages(packages), *packages.options.successors}
    told: set[tuple[str, str]] = set()
    for path in packages.files(*_LAUNCHES, *OF_XML):
        text = packages.read(path).data.decode("utf-8", "replace")
        is_read = path.endswith((*_LAUNCHES, ".xacro")) or "<robot" in text
        text = re.sub(_COMMENT[".py" if path.endswith(".py") else ".xml"], "", text)
        for found in _LOOKUP.finditer(text) if is_read else ():
            name = found["share"] or found["find"]
            is_launch = found["source"] or found["include"]
            if name in own or is_launch or _IN_ROS_2.fullmatch(name) or (path, name) in told:
                continue
            told.add((path, name))
            what = (
                f"no distro of ROS 2 has package '{name}'" if is_lost(name) else f"check that package '{name}' exists"
            )
            target = "" if is_lost(name) else f" for {packages.options.target}"
            program = "the launch file" if path.endswith(_LAUNCHES) else "xacro"
            what = f"{what}{target}: {program} looks for it, and ends where it does not find it"
            entry = ReportEntry(EntryKind.FOR_YOU, what, file=os.path.realpath(path), authority=_AUTHORITY)
            yield Proposal(entries=(entry,))
