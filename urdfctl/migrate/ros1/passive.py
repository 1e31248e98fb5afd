"""The joints that get no command interface: those that mimic another one, and those that a simulator plugin moves.

The plugin for ros2_control holds a joint with a command interface until a controller claims it. That of ROS 1 applied
no effort to such a joint, so that another plugin could move it: a differential, a spring.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import session_of
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.followers import followers_of
from urdfctl.migrate.ros1.interfaces import commands_of
from urdfctl.migrate.ros1.uses import Uses
from urdfctl.migrate.shared.hardware import host_plugin
from urdfctl.model.robot import Robot

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
        self._commanded = frozenset(_commanded(packages))
        self._known: dict[int, Mapping[str, str]] = {}

    def of(self, robot: int) -> Mapping[str, str]:
        """Return the joints of a robot, each with the parameters that the hardware plugin needs for it."""
        if robot not in self._known:
            followers = followers_of(self._packages, self._uses.robots[robot].project)
            self._known[robot] = {**dict.fromkeys(self.moved(robot), ""), **followers}
        return self._known[robot]

    def moved(self, robot: int) -> set[str]:
        """Return the joints of a robot that another plugin of the simulator moves."""
        found = self._uses.robots[robot].project.robot
        if found is None or host_plugin(self._packages) is None:
            return set()
        free = set(_by_effort(found)) & set(_named_by_plugins(found, ""))
        driven = set(_transmitted(found)) & set(_named_by_plugins(found, _DRIVES))
        return (free | driven) - self._commanded


def _commanded(packages: MigratedPackages) -> Iterator[str]:
    """The joints that the controllers of ROS 1 command."""
    for loaded in packages.loaded():
        for controller in session_of(loaded.project, _DISTRO).controllers if loaded.project.controllers else ():
            yield from (claim.component for claim in controller.claimed(ClaimKind.COMMAND))


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
