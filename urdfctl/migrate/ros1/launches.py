"""The launch files of ROS 1 in the packages, whatever their names end with."""

from __future__ import annotations

import os
from collections.abc import Collection

from urdfctl.migrate.edits.markup import root_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.model.launch.ros1 import is_of_ros2
from urdfctl.source.xml.dom import Element

ENDINGS = (".launch", ".xml")
"""roslaunch reads any file: `upload_robot.xml` is included as often as `robot.launch`."""
_OLD = (".launch.xml", ".launch", ".xml")


def launch_roots(packages: MigratedPackages) -> dict[str, Element]:
    """Return the root elements of the launch files of ROS 1, by their paths."""
    found = {}
    for path in packages.files(*ENDINGS):
        source = packages.read(path)
        root = root_of(source) if b"<launch" in source.data else None
        if root is not None and root.tagName == "launch" and not is_of_ros2(root):
            found[path] = root
    return found


def new_name(name: str, ending: str, doubled: Collection[str]) -> str:
    """Return the name of a migrated launch file; the same for a file that is none by its name.

    ending: that of migrated launch files.
    doubled: the names of the files that would get the name of another one.
    """
    old = next((each for each in _OLD if name.endswith(each)), None)
    if old is None:
        return name
    return f"{name.removesuffix(old)}{'_include' if os.path.basename(name) in doubled else ''}{ending}"


def doubled_names(packages: MigratedPackages) -> frozenset[str]:
    """Return the names of launch files beside another one that differs only in its ending: robot.launch.xml beside
    robot.launch, which includes it."""
    paths = packages.found(launch_roots)
    plain = {path.removesuffix(".launch") for path in paths if path.endswith(".launch")}
    others = [path for path in paths if not path.endswith(".launch")]
    found = {path for path in others if path.removesuffix(".xml").removesuffix(".launch") in plain}
    longer = {path.removesuffix(".launch.xml") for path in others if path.endswith(".launch.xml")}
    found |= {path for path in others if not path.endswith(".launch.xml") and path.removesuffix(".xml") in longer}
    return frozenset(map(os.path.basename, found))
