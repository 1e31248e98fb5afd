"""Which distro and simulator a robot is for, by the weight of everything that indicates it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from urdfctl.catalog.distros import ALL, MAINTAINED, ROS2
from urdfctl.config.settings import Settings
from urdfctl.load.origin.evidence import (
    EXPLICIT,
    ROS1,
    items_of_controllers,
    items_of_headers,
    items_of_launch,
    items_of_moveit,
    items_of_package,
    items_of_robot,
)
from urdfctl.load.origin.repository import PROSE, items_of_repository
from urdfctl.model.project import Evidence, EvidenceItem
from urdfctl.model.robot import Robot
from urdfctl.source.span import SourceText
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.load.controller_files import ControllerFiles
    from urdfctl.model.launch import Launch
    from urdfctl.model.moveit import MoveIt

_ANY = (*ROS1, *ROS2)
_SIMULATORS = {
    "libgazebo_ros_control.so": "gazebo-classic",
    "gazebo_ros2_control": "gazebo-classic",
    "gz_ros2_control": "gz",
    "ign_ros2_control": "gz",
    "mujoco_ros2_control": "mujoco",
}
"""What the names of plugins hold that connect ros_control or ros2_control to a simulator."""


class Beside(NamedTuple):
    """What is read beside a robot.

    package: the folder of the package that contains it.
    sources: the texts of all files that were read.
    moveit: the configuration of MoveIt.
    workspace: the folder of the workspace.
    path: the description or launch file.
    """

    package: str | None = None
    controllers: ControllerFiles | None = None
    launch: Launch | None = None
    sources: Sequence[SourceText] = ()
    moveit: MoveIt | None = None
    workspace: str | None = None
    path: str | None = None


def detect_distro(robot: Robot | None, beside: Beside, settings: Settings) -> Evidence:
    """Return the distro that the settings name, or `$ROS_DISTRO`, or otherwise the distros that most of the files
    indicate; and the simulator."""
    simulator, simulator_from = _simulator(robot, beside.launch, settings)
    return _distro(robot, beside, settings)._replace(simulator=simulator, simulator_from=simulator_from)


def _distro(robot: Robot | None, beside: Beside, settings: Settings) -> Evidence:
    named, source = settings.distro, settings.distro_from or "--distro"
    if named is None and settings.environ.get("ROS_DISTRO", "") in ALL:
        named, source = settings.environ["ROS_DISTRO"], "$ROS_DISTRO"
    if named is not None:
        return Evidence(named, (named,), source, items=(EvidenceItem("user", source, (named,), EXPLICIT),))
    return weighed(_items(robot, beside))


def _items(robot: Robot | None, beside: Beside) -> Iterator[EvidenceItem]:
    yield from items_of_robot(robot)
    yield from items_of_package(beside.package)
    yield from items_of_controllers(beside.controllers)
    yield from items_of_launch(beside.launch)
    yield from items_of_moveit(beside.moveit)
    yield from items_of_headers(beside.sources)
    if beside.workspace and beside.path:
        started = beside.launch.path if beside.launch else beside.path
        yield from items_of_repository(beside.package or os.path.dirname(started), beside.workspace)


def weighed(items: Iterable[EvidenceItem]) -> Evidence:
    """Return the generation that most of the evidence is for, and those of its distros that fit it best.

    If both generations have the same weight, the first item decides. Items that only distros without support have
    do not exclude the others: one of them is more likely a fault.
    """
    items = tuple(items)
    weights = {ros: _weight(item for item in items if item.ros == ros) for ros in (1, 2)}
    told = [item for item in items if item.ros is not None]
    if not told:
        return Evidence(None, _ANY, None, items=items)
    ros = told[0].ros if weights[1] == weights[2] else max(weights, key=lambda each: weights[each])
    family = ROS1 if ros == 1 else ROS2
    mine = [item for item in told if item.ros == ros]
    distros = _narrowed(family, [item for item in items if set(item.distros) & set(family)])
    most = max(mine, key=lambda item: item.weight)
    if len(distros) == 1:
        naming = (item for item in items if set(item.distros) & set(family) == set(distros))
        most = max(naming, key=lambda item: item.weight, default=most)
    return Evidence(distros[0] if len(distros) == 1 else None, distros, most.what, items=items)


def without_prose(evidence: Evidence) -> Evidence:
    """Return what is left of the evidence for a distro without the prose of a README."""
    items = [item for item in evidence.items if item.kind != PROSE]
    return evidence if len(items) == len(evidence.items) else weighed(items)


def _weight(items: Iterable[EvidenceItem]) -> int:
    """The weight of items together: of each kind, the heaviest counts."""
    by_kind: dict[str, int] = {}
    for item in items:
        by_kind[item.kind] = max(item.weight, by_kind.get(item.kind, 0))
    return sum(by_kind.values())


def _narrowed(family: tuple[str, ...], items: Sequence[EvidenceItem]) -> tuple[str, ...]:
    """The distros of a generation that most items allow."""
    living = {*MAINTAINED, "noetic"} & set(family)
    narrowing = [item for item in items if not set(family) <= set(item.distros)]
    narrowing = [item for item in narrowing if item.weight >= EXPLICIT or living & set(item.distros)]
    support = {distro: sum(item.weight for item in narrowing if distro in item.distros) for distro in family}
    return tuple(distro for distro in family if support[distro] == max(support.values()))


def _simulator(robot: Robot | None, launch: Launch | None, settings: Settings) -> tuple[str | None, str | None]:
    """Return the simulator in the settings, the one that the launch file starts, or the one that all plugins are made
    for, and where it comes from. A launch file that starts a controller manager and no simulator loads no plugin."""
    if settings.simulator:
        return settings.simulator, settings.simulator_from or "--simulator"
    launched = {simulation.simulator for simulation in launch.simulations if simulation.sure} if launch else set()
    if len(launched) == 1:
        return launched.pop(), "the launch file"
    if launch is not None and launch.runs_without_simulator:
        return None, None
    plugins = {simulator: name for name, simulator in _simulators_of(robot)}
    if len(plugins) != 1:
        return None, None
    simulator, plugin = plugins.popitem()
    return simulator, f"the plugin '{plugin}'"


def _simulators_of(robot: Robot | None) -> Iterator[tuple[str, str]]:
    """Yield the plugins that only one simulator can load, each with that simulator."""
    if robot is None:
        return
    hardware = (plugin.value for control in robot.ros2_controls for part in control.hardware for plugin in part.plugins)
    for name in (*(plugin.filename or "" for plugin in robot.plugins), *hardware):
        for known, simulator in _SIMULATORS.items():
            if known in name:
                yield name, simulator
