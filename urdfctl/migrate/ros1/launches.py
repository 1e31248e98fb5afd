"""The launch files of ROS 1 in the packages, whatever their names end with."""

from __future__ import annotations

from urdfctl.migrate.edits.markup import root_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.model.launch.ros1 import is_of_ros2
from urdfctl.source.xml.dom import Element

ENDINGS = (".launch", ".xml")
"""roslaunch reads any file: `upload_robot.xml` is included as often as `robot.launch`."""


def launch_roots(packages: MigratedPackages) -> dict[str, Element]:
    """Return the root elements of the launch files of ROS 1, by their paths."""
    found = {}
    for path in packages.files(*ENDINGS):
        source = packages.read(path)
        root = root_of(source) if b"<launch" in source.data else None
        if root is not None and root.tagName == "launch" and not is_of_ros2(root):
            found[path] = root
    return found
