"""What the models say that a launch file spawns from SDF files, beside the description that it publishes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfctl.model.robot import Plugin, Robot, Tag
from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.problem import ReadError
from urdfctl.source.xml.parsing import parse

if TYPE_CHECKING:
    from urdfctl.model.launch import Launch

_CONTROL = ("ros2_control", "gazebo_ros_control")


def with_spawned(robot: Robot | None, launch: Launch | None, files: Files) -> Robot | None:
    """Return a robot with the plugins for its controllers that stand in the SDF file from which it is spawned.

    The simulator loads the plugins of that file, and its controller manager reads the description that
    robot_state_publisher has (gz_ros2_control, gz_ros2_control_plugin.cpp). Nothing is added if several files have such
    plugins: it is not known which model is the robot; nor if the description has one: the file was made from it.
    """
    if robot is None or launch is None or len(launch.robots) > 1 or any(map(_has_manager, robot.plugins)):
        return robot
    found = [plugins for path in _spawned_files(launch) if (plugins := tuple(_control_plugins(path, files)))]
    return robot._replace(spawned=found[0]) if len(found) == 1 else robot


def _spawned_files(launch: Launch) -> Iterator[str]:
    """The SDF files that are named as arguments of nodes."""
    named = (one.file for one in launch.references if one.use == "argument" and one.sure and one.file.exists)
    yield from dict.fromkeys(file.path for file in named if file.path and file.path.endswith(".sdf"))


def _control_plugins(path: str, files: Files) -> Iterator[Plugin]:
    """The plugins in an SDF file that have a controller manager."""
    try:
        root = parse(files.read(path)).documentElement
    except (FileProblem, ReadError):
        return
    for model in (child for child in root.elements() if child.tagName == "model") if root else ():
        for child in (inner for inner in model.elements() if inner.tagName == "plugin"):
            plugin = Plugin(child.attrs.get("name"), child.attrs.get("filename"), child.at, Tag(child))
            if _has_manager(plugin):
                yield plugin


def _has_manager(plugin: Plugin) -> bool:
    return any(name in (plugin.filename or "") for name in _CONTROL)
