"""The joints that get no command interface: those that mimic another one, and those that a simulator plugin moves.

The plugin for ros2_control holds a joint with a command interface until a controller claims it. That of ROS 1 applied
no effort to such a joint, so that another plugin could move it: a differential, a spring.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator, Mapping

from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import session_of
from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.migrate.ros1.followers import followers_of
from urdfctl.migrate.ros1.interfaces import commands_of
from urdfctl.migrate.ros1.uses import Uses
from urdfctl.migrate.shared.hardware import host_plugin
from urdfctl.model.robot import Robot
from urdfctl.source.workspaces.packages import package_around

HELD = "gz_ros2_control and gazebo_ros2_control doc/index.rst: hold_joints, which is true by default"
_DISTRO = "noetic"
_READERS = ("joint_state_publisher", "ft_sensor", "p3d", "f3d")
"""Parts of the names of plugins that only read joints."""
_DRIVES = "_drive"
"""A part of the names of plugins that move wheels, whose velocity a plugin for ros2_control sets to zero."""


class Passive:
    """The joints of robots that nothing commands."""

    def __init__(self, packages: MigratedPackages, uses: Uses) -> None:
        self._packages, self._uses = packages, uses
        self._claims = list(_claims(packages))
        self._known: dict[int, Mapping[str, str]] = {}
        self._moved: dict[int, frozenset[str]] = {}

    def of(self, robot: int) -> Mapping[str, str]:
        """Return the joints of a robot, each with the parameters that the hardware plugin needs for it."""
        if robot not in self._known:
            followers = followers_of(self._packages, self._uses.robots[robot].project)
            self._known[robot] = {**dict.fromkeys(self.moved(robot), ""), **followers}
        return self._known[robot]

    def shared(self, robots: Collection[int]) -> Mapping[str, str]:
        """Return the joints that nothing commands in several robots, which have them from one text."""
        found = {joint: text for robot in robots for joint, text in self.of(robot).items()}
        moved = {joint for robot in robots for joint in self.moved(robot)}
        commanded = {joint for robot in robots for joint in self._commanded(robot)}
        return {joint: text for joint, text in found.items() if joint not in moved & commanded}

    def moved(self, robot: int) -> frozenset[str]:
        """Return the joints of a robot that another plugin of the simulator moves."""
        if robot not in self._moved:
            self._moved[robot] = frozenset(self._movable(robot)) - self._commanded(robot)
        return self._moved[robot]

    def _movable(self, robot: int) -> set[str]:
        found = self._uses.robots[robot].project.robot
        if found is None or host_plugin(self._packages) is None:
            return set()
        free = set(_by_effort(found)) & set(_named_by_plugins(found, ""))
        driven = set(_transmitted(found)) & set(_named_by_plugins(found, _DRIVES))
        return free | driven

    def _commanded(self, robot: int) -> set[str]:
        """The joints that controllers of ROS 1 command, without the controllers of other robots."""
        own = self._uses.robots[robot]
        return {joint for loaded, joints in self._claims if _may_be_of(loaded, joints, own) for joint in joints}


def _claims(packages: MigratedPackages) -> Iterator[tuple[LoadedTarget, frozenset[str]]]:
    """The joints that each controller of ROS 1 commands, with the target that has it."""
    for loaded in packages.loaded():
        for controller in session_of(loaded.project, _DISTRO).controllers if loaded.project.controllers else ():
            yield loaded, frozenset(claim.component for claim in controller.claimed(ClaimKind.COMMAND))


def _may_be_of(loaded: LoadedTarget, joints: frozenset[str], own: LoadedTarget) -> bool:
    """Whether a controller of a target, which commands some joints, may be for the robot of another target.

    One without a robot may be if the robot has its joints; one of another robot is not, unless that is a variant: by
    its name, its package or a file that both include.
    """
    robot, other = own.project.robot, loaded.project.robot
    if robot is None or other is None:
        return robot is None or joints <= {joint.name for joint in robot.joints}
    if robot.name == other.name:
        return True
    packages = [package_around(os.path.dirname(os.path.realpath(each.project.path))) for each in (loaded, own)]
    return packages[0] == packages[1] or bool(_descriptions(loaded) & _descriptions(own))


def _descriptions(loaded: LoadedTarget) -> set[str]:
    files = (os.path.realpath(path) for path in loaded.sources if path.endswith(OF_XML))
    return {path for path in files if os.path.basename(path) != "package.xml"}


def _by_effort(robot: Robot) -> Iterator[str]:
    """The joints whose only command interface is effort."""
    for transmission in robot.transmissions:
        for joint in transmission.kept_joints:
            if joint.name and {commands_of(one.value) for one in joint.named_interfaces} == {("effort",)}:
                yield joint.name


def _transmitted(robot: Robot) -> Iterator[str]:
    for transmission in robot.transmissions:
        yield from (joint.name for joint in transmission.kept_joints if joint.name)


def _named_by_plugins(robot: Robot, part_of_name: str) -> Iterator[str]:
    """The settings of the plugins with a part in their names, without those that only read joints."""
    for plugin in robot.plugins:
        filename = plugin.filename or ""
        if part_of_name in filename and not any(part in filename for part in _READERS):
            yield from (setting.text for setting in plugin.tag.children)
