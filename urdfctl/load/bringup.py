"""What a launch file starts together, as reports and `urdfctl show` describe it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from urdfctl.load.target import Target
from urdfctl.source.disk.files import is_launch
from urdfctl.source.opaque import UNKNOWN
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.model.controllers import FileReference
    from urdfctl.model.launch import Launch, Word

_MOVE_GROUP = ("moveit_ros_move_group", "move_group")


class Bringup(NamedTuple):
    """What a launch file starts together.

    arguments: the launch arguments that were given.
    told_at: where these are documented, as `PATH:LINE`; None if they are not.
    namespace: of the description; empty for the root, None if unknown or if there is no description.
    spawned: the names of controllers that are spawned, with their namespaces if known.
    includes: the launch files that it includes, and that were found.
    simulators: those that it starts.
    moveit: True if it starts MoveIt's move_group.
    complete: False if some of what it starts is unknown.
    others: the descriptions of its other robots, each with the namespace of the robot.
    unfollowed: included launch files that are worth checking on their own.
    beside: the launch files that are started beside it, in other terminals.
    absent: the packages that are not here and of which it starts launch files.
    unloaded: the packages that are not here and of which it loads parameter files.
    loads_known: False if nothing names a parameter file that it loads.
    """

    arguments: tuple[tuple[str, str], ...] = ()
    namespace: str | None = None
    spawned: tuple[str, ...] = ()
    includes: tuple[str, ...] = ()
    simulators: tuple[str, ...] = ()
    moveit: bool = False
    complete: bool = True
    others: tuple[tuple[str, str | None], ...] = ()
    unfollowed: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()
    told_at: str | None = None
    absent: tuple[str, ...] = ()
    unloaded: tuple[str, ...] = ()
    loads_known: bool = True

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Bringup:
        """Return the bringup that `_asdict` and JSON made `data` from."""
        arguments = tuple((name, value) for name, value in data["arguments"])
        names = ("spawned", "includes", "simulators", "unfollowed", "beside", "absent", "unloaded")
        lists = {name: tuple(data[name]) for name in names}
        others = tuple((path, namespace) for path, namespace in data["others"])
        return cls(**{**data, **lists, "arguments": arguments, "others": others})


def bringup_of(launch: Launch, target: Target) -> Bringup:
    """Return what the launch file of a target, with its arguments, and others beside it start together."""
    description = launch.description
    named = [(spawn, name) for spawn in launch.spawns for name, _ in spawn.names if UNKNOWN not in name]
    spawned = (spawn.full_name(name) if spawn.namespace else name for spawn, name in named)
    all_named = all(spawn.complete for spawn in launch.spawns) and len(named) == sum(
        len(spawn.names) for spawn in launch.spawns
    )
    simulators = [simulation.simulator for simulation in launch.simulations if simulation.sure]
    unloaded = [load.file for load in launch.loads if load.file.path is None and not load.in_node]
    included = (reference.file for reference in launch.references if reference.use == "include" and reference.sure)
    return Bringup(
        arguments=target.arguments if is_launch(target.path) else (),
        told_at=target.told_at,
        namespace=description.namespace if description else None,
        spawned=tuple(dict.fromkeys(spawned)),
        includes=tuple(dict.fromkeys(file.path for file in included if file.path and file.exists)),
        simulators=tuple(dict.fromkeys([*simulators, *(["webots"] if launch.runs_webots else [])])),
        moveit=any(node.runs(*_MOVE_GROUP) for node in launch.nodes) or any(each.runs for each in launch.moveit),
        complete=launch.complete and all_named,
        others=tuple((robot.file.path, robot.namespace) for robot in launch.others if robot.file.path),
        unfollowed=launch.unfollowed,
        beside=tuple(os.path.abspath(start.path) for start in target.beside),
        absent=_packages_of(launch.absent) if launch.absent else (),
        unloaded=_packages_of(unloaded) if unloaded else (),
        loads_known=all(_packages_of([file]) for file in unloaded),
    )


def _packages_of(files: Sequence[Word | FileReference]) -> tuple[str, ...]:
    from urdfctl.source.workspaces.robot_starts import package_of

    return tuple(dict.fromkeys(name for word in files if (name := package_of(word.text))))
