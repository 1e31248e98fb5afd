"""Which distro and simulator a robot is for, and what tells so."""

from __future__ import annotations

import os
import re
from typing import NamedTuple

from urdfctl.catalog.distros import ALL, ROS2, generation, since
from urdfctl.model.robot import Robot
from urdfctl.settings import Settings

ROS1 = since("indigo")
"""What a robot of ROS 1 may be for when nothing says more: hydro read transmissions in another form, ten years ago."""
_ANY = (*ROS1, *ROS2)
_MANIFEST_BYTES = 65536
_ROS1_PLUGINS = ("libgazebo_ros_control.so",)
_ROS2_PLUGINS = ("libgazebo_ros2_control.so", "gz_ros2_control", "ign_ros2_control")


class Evidence(NamedTuple):
    """The distro if it is known, those it may be, and from what."""

    distro: str | None
    distros: tuple[str, ...]
    source: str | None
    simulator: str | None

    @property
    def ros(self) -> int | None:
        """1 or 2, None where not known."""
        generations = {generation(distro) for distro in self.distros}
        return generations.pop() if len(generations) == 1 else None


def judged(robot: Robot | None, package: str | None, settings: Settings, form: int | None = None) -> Evidence:
    """By the settings first, then `$ROS_DISTRO`, then what the files say: the robot, then the generation of ROS that
    its controllers' files are written for, then its package's manifest."""
    simulator = settings.simulator
    if settings.distro:
        return Evidence(settings.distro, (settings.distro,), "--distro", simulator)
    named = settings.environ.get("ROS_DISTRO", "")
    if named in ALL:
        return Evidence(named, (named,), "$ROS_DISTRO", simulator)
    by_robot = _by_robot(robot)
    if by_robot:
        return Evidence(None, *by_robot, simulator)
    if form is not None:
        told = "ros__parameters" if form == 2 else "the controllers' types"  # noqa: PLR2004
        return Evidence(None, ROS2 if form == 2 else ROS1, told, simulator)  # noqa: PLR2004
    by_manifest = _by_manifest(package)
    if by_manifest:
        return Evidence(None, *by_manifest, simulator)
    if robot is not None and robot.transmissions:
        return Evidence(None, ROS1, "<transmission>", simulator)
    return Evidence(None, _ANY, None, simulator)


def _by_robot(robot: Robot | None) -> tuple[tuple[str, ...], str] | None:
    if robot is None:
        return None
    if robot.ros2_controls:
        return ROS2, "<ros2_control>"
    files = [plugin.filename or "" for plugin in robot.plugins]
    for filename in files:
        if any(known in filename for known in _ROS2_PLUGINS):
            return ROS2, f"the plugin '{filename}'"
        if filename in _ROS1_PLUGINS:
            return ROS1, f"the plugin '{filename}'"
    return None


def _by_manifest(package: str | None) -> tuple[tuple[str, ...], str] | None:
    if package is None:
        return None
    try:
        with open(os.path.join(package, "package.xml"), encoding="utf-8", errors="replace") as file:
            text = file.read(_MANIFEST_BYTES)
    except OSError:
        return None
    text = re.sub(r"<!--.*?(?:-->|\Z)", "", text, flags=re.DOTALL)
    ament = re.search(r"<build_type[^>]*>\s*ament|<buildtool_depend[^>]*>\s*ament", text)
    catkin = re.search(r"<build_type[^>]*>\s*catkin|<buildtool_depend[^>]*>\s*catkin", text)
    if bool(ament) == bool(catkin):
        return None
    return (ROS2 if ament else ROS1), "package.xml"
