"""Where launch files of ROS 2 set the simulation's time: before the nodes that need it."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

from urdfctl.migrate.classic.launch_actions import CLASSIC_PACKAGE, is_spawner, starts_classic
from urdfctl.migrate.edits.markup import attribute, elements
from urdfctl.migrate.launch.actions import Action, Text, all_actions, is_literal
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.included import IncludedFile
from urdfctl.migrate.ros1.launch_target import LaunchTarget
from urdfctl.migrate.ros1.launches import launch_roots
from urdfctl.migrate.shared.controller_files import type_names
from urdfctl.source.workspaces.packages import package_around, package_name

_STARTING = ("node", "include", "group", "process")
_TIMED = ("controller_manager", CLASSIC_PACKAGE)
"""Packages whose nodes have the simulation's time, or need none."""
_TOOLS = frozenset(
    "joint_state_publisher joint_state_publisher_gui joy robot_state_publisher rqt_controller_manager rqt_gui rviz2 "
    "teleop_twist_joy teleop_twist_keyboard tf2_ros twist_mux".split()
)
"""Packages whose nodes are started for simulated robots and real ones; others may be drivers of a real one."""
_OWN_MANAGER = b"controller_manager::ControllerManager"


def time_first(actions: Sequence[Action]) -> list[Action]:
    """Return the actions of a launch file with use_sim_time before the first that starts something.

    A parameter of ROS 1 is global wherever it is set; SetParameter is only for the nodes after it (launch_ros
    actions/set_parameter.py). An argument that it reads is declared before it, unless its default reads others.
    """
    found = [one for one in actions if one.kind == "set_parameter" and one.name == "use_sim_time" and not one.condition]
    started = next((index for index, one in enumerate(actions) if one.kind in _STARTING), len(actions))
    if not found or found[-1] in actions[:started]:
        return list(actions)
    read = {part.text for part in found[-1].value or () if part.kind == "arg"}
    declared = [one for one in actions if one.kind in ("argument", "let") and one.name in read]
    if not all(is_literal(one.value or ()) and not one.condition for one in declared):
        return list(actions)
    return [*declared, found[-1], *(one for one in actions if one not in (*found, *declared))]


def needs_time(actions: Sequence[Action], included: Mapping[Text, IncludedFile], target: LaunchTarget) -> bool:
    """Return whether actions start, spawn into or control what a simulator runs, and start a node that needs its time or
    another launch file, which may start one: empty_world.launch set that for all nodes, also for those of launch files
    that were started later."""
    every = list(all_actions(tuple(actions)))
    nodes = [one for one in every if one.kind == "node"]
    inner = [included.get(one.value or ()) for one in every if one.kind == "include"]
    worlds = [one for one in every if starts_classic(one)]
    files = [one for one in inner if one is not None]
    is_set = any(action.kind == "set_parameter" and action.name == "use_sim_time" for action in every)
    starts = bool(worlds) or any(map(is_spawner, every)) or any(one.starts for one in files)
    spawns = any(one.package == "controller_manager" for one in nodes) or any(one.spawns for one in files)
    controls = spawns or any(target.commands(one.package, one.name) for one in nodes)
    is_of_robot = all(one.package in target.own or one.package in (*_TIMED, *_TOOLS) for one in nodes)
    starts |= controls and is_of_robot and target.simulated and not target.may_be_real
    is_needed = any(one.package not in _TIMED for one in nodes) or len(inner) > 1
    return starts and not is_set and is_needed


def may_be_real(packages: MigratedPackages) -> bool:
    """Return whether launch files may control a real robot, too: a program has a manager of its own, or a launch file
    decides itself whether the time is the simulator's."""
    if any(_OWN_MANAGER in packages.read(path).data for path in packages.files(".cpp", ".cc", ".h", ".hpp")):
        return True
    every = [one for root in packages.found(launch_roots).values() for one in elements(root) if one.tagName == "param"]
    values = [attribute(one, "value") for one in every if attribute(one, "name").rpartition("/")[2] == "use_sim_time"]
    return any(value.lower() not in ("true", "1") for value in values)


def commanding_programs(packages: MigratedPackages) -> frozenset[tuple[str, str]]:
    """Return the programs whose text names the topic on which a controller reads commands, with their packages."""
    topics = [f"{one.controller.rpartition('/')[2]}/command".encode() for one in packages.found(type_names)]
    found = set()
    for path in packages.files(".py"):
        text = packages.read(path).data
        folder = package_around(os.path.dirname(path)) if any(topic in text for topic in topics) else None
        if folder is not None:
            found.add((package_name(os.path.join(folder, "package.xml")) or "", os.path.basename(path)))
    return frozenset(found)
