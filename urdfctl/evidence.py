"""Which distro and simulator a robot is for, and what tells so."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence

from urdfctl.catalog.distros import ALL, ROS2, generation, since
from urdfctl.model.robot import Robot
from urdfctl.record import NamedTuple
from urdfctl.settings import Settings
from urdfctl.source.files import first_bytes

ROS1 = since("indigo")
"""What a robot of ROS 1 may be for when nothing says more: hydro read transmissions in another form, ten years ago."""
_ANY = (*ROS1, *ROS2)
_MANIFEST_BYTES = 65536
_ROS1_PLUGINS = ("libgazebo_ros_control.so",)
_SIMULATORS = {
    "libgazebo_ros_control.so": "gazebo-classic",
    "gazebo_ros2_control": "gazebo-classic",
    "gz_ros2_control": "gz",
    "ign_ros2_control": "gz",
    "mujoco_ros2_control": "mujoco",
}
"""What the names of plugins hold that connect ros_control or ros2_control to a simulator."""
_ROS2_PLUGINS = ("libgazebo_ros2_control.so", "gz_ros2_control", "ign_ros2_control")


class Evidence(NamedTuple):
    """The distro if it is known, those it may be, and from what; the simulator if it is known, and from what."""

    distro: str | None
    distros: tuple[str, ...]
    source: str | None
    simulator: str | None = None
    simulator_from: str | None = None

    @property
    def ros(self) -> int | None:
        """1 or 2, None where not known."""
        generations = {generation(distro) for distro in self.distros}
        return generations.pop() if len(generations) == 1 else None


class OfFiles(NamedTuple):
    """A generation of ROS that files beside the robot are written for, and what tells so."""

    ros: int
    source: str


def judged(robot: Robot | None, package: str | None, settings: Settings, of_files: OfFiles | None = None) -> Evidence:
    """By the settings first, then `$ROS_DISTRO`, then what the files say: the robot, then its package's manifest, then
    the generation of ROS that its controllers' files or launch file are written for."""
    simulator, simulator_from = _simulator(robot, settings)
    return _distro(robot, package, settings, of_files)._replace(simulator=simulator, simulator_from=simulator_from)


def _distro(robot: Robot | None, package: str | None, settings: Settings, of_files: OfFiles | None) -> Evidence:
    if settings.distro:
        return Evidence(settings.distro, (settings.distro,), settings.distro_from or "--distro")
    named = settings.environ.get("ROS_DISTRO", "")
    if named in ALL:
        return Evidence(named, (named,), "$ROS_DISTRO")
    by_robot = _by_robot(robot)
    if by_robot:
        return Evidence(None, *by_robot)
    by_manifest = _by_manifest(package)
    if by_manifest:
        return Evidence(None, *by_manifest)
    if of_files is not None:
        return Evidence(None, ROS2 if of_files.ros == 2 else ROS1, of_files.source)  # noqa: PLR2004
    if robot is not None and robot.transmissions:
        return Evidence(None, ROS1, "<transmission>")
    return Evidence(None, _ANY, None)


def _simulator(robot: Robot | None, settings: Settings) -> tuple[str | None, str | None]:
    """The simulator that the user names, else the one that all plugins of Gazebo and of ros2_control are made for."""
    if settings.simulator:
        return settings.simulator, settings.simulator_from or "--simulator"
    found = {known: name for name, known in _simulators_of(robot)}
    if len(found) != 1:
        return None, None
    simulator, plugin = found.popitem()
    return simulator, f"the plugin '{plugin}'"


def _simulators_of(robot: Robot | None) -> Iterator[tuple[str, str]]:
    """The plugins that only one simulator can load, each with that simulator."""
    if robot is None:
        return
    hardware = (plugin.value for control in robot.ros2_controls for part in control.hardware for plugin in part.plugins)
    for name in (*(plugin.filename or "" for plugin in robot.plugins), *hardware):
        for known, simulator in _SIMULATORS.items():
            if known in name:
                yield name, simulator


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


def ament_package(packages: Sequence[str]) -> str | None:
    """One of several packages, two at least, where all are of ROS 2."""
    told = {_by_manifest(package) for package in packages}
    return packages[0] if len(packages) > 1 and told == {(ROS2, "package.xml")} else None


def _by_manifest(package: str | None) -> tuple[tuple[str, ...], str] | None:
    if package is None:
        return None
    try:
        text = first_bytes(os.path.join(package, "package.xml"), _MANIFEST_BYTES).decode("utf-8", "replace")
    except OSError:
        return None
    text = re.sub(r"<!--.*?(?:-->|\Z)", "", text, flags=re.DOTALL)
    ament = re.search(r"<build_type[^>]*>\s*ament|<buildtool_depend[^>]*>\s*ament", text)
    catkin = re.search(r"<build_type[^>]*>\s*catkin|<buildtool_depend[^>]*>\s*catkin", text)
    if bool(ament) == bool(catkin):
        return None
    return (ROS2 if ament else ROS1), "package.xml"
