"""What spawns controllers in ROS 2: nodes or commands, one for each controller or for several, one after the other."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from systems.possible import LOOPS, waits_for_start
from systems.render.actions import Action, After, Execute, Loop, Name, Node, Share, Timer, Value
from systems.render.arguments import Values
from systems.render.places import config_folder, pick
from systems.system import Robot, Spawn, System

_TIMEOUTS: dict[str, list[Value]] = {
    "none": [],
    "whole": [("--controller-manager-timeout",), ("60",)],
    "beginning": [("--controller-manager-time",), ("60",)],
    "with value": [("--controller-manager-t=60",)],
}
"""An option of the spawner, as the switch says."""
LISTED = "spawned.yaml"
"""The file with the names of the controllers that are spawned, if they are read from one."""


def spawners(values: Values, namespace: Value) -> list[Action]:
    """Return what spawns a robot's controllers. namespace: of the nodes, if they have one of their own."""
    form = values.idioms["spawners"]
    spawned = values.robot.spawned
    if form == "command line":
        found: list[Action] = [_command(values, spawn) for spawn in spawned]
    elif form in LOOPS:
        found = _loop(values, namespace, form)
    elif form == "each":
        found = [_node(values, namespace, [spawn]) for spawn in spawned]
    else:
        kinds = ([spawn for spawn in spawned if spawn.active is active] for active in (True, False))
        found = [_node(values, namespace, group) for group in kinds if group]
    return _ordered(values, found)


def _words(values: Values, spawned: Sequence[Spawn]) -> list[Value]:
    main = values.robot.spawned[1].name if len(values.robot.spawned) > 1 else ""
    return [values.controller if spawn.name == main else (spawn.name,) for spawn in spawned]


def _node(values: Values, namespace: Value, spawned: Sequence[Spawn]) -> Node:
    words = [*_words(values, spawned), *_options(values)]
    words += [] if spawned[0].active else [("--inactive",)]
    label = f"{_owner(values)}{spawned[0].name}_spawner"
    return Node("controller_manager", "spawner", "", namespace, (), tuple(words), label=label)


def _options(values: Values) -> list[Value]:
    system, how = values.system, values.idioms["manager option"]
    words: list[Value] = []
    if how != "none":
        option = pick(system, "manager option", ("--controller-manager", "-c"))
        words = [(option,), _manager(values) if how == "absolute" else (values.robot.asked,)]
    words += _TIMEOUTS[values.idioms["timeout"]]
    if values.idioms["param file"] == "given":
        words += [(pick(system, "param option", ("--param-file", "-p")),), values.files[-1]]
    return words


def _manager(values: Values) -> Value:
    """The full name of the manager."""
    namespace = values.namespace
    return ("/", *namespace, f"/{values.robot.asked}") if namespace else (f"/{values.robot.asked}",)


def _command(values: Values, spawn: Spawn) -> Execute:
    state = "active" if spawn.active else "inactive"
    words: list[Value] = [("ros2",), ("control",), ("load_controller",), ("--set-state",), (state,)]
    words += _words(values, [spawn])
    robot = values.robot
    if robot.namespace or robot.asked != "controller_manager":
        words += [("-c",), _manager(values)]
    return Execute(tuple(words), f"load_{_owner(values)}{spawn.name}")


def _owner(values: Values) -> str:
    """What tells the processes of two robots apart."""
    return f"{values.robot.name}_" if values.system.is_fleet else ""


def _loop(values: Values, namespace: Value, style: str) -> list[Action]:
    """A loop over the names of the active controllers, and nodes for the others."""
    active = [spawn for spawn in values.robot.spawned if spawn.active]
    node = Node("controller_manager", "spawner", "", namespace, (), ((Name(),), *_options(values)))
    others = [_node(values, namespace, [spawn]) for spawn in values.robot.spawned if not spawn.active]
    names = tuple(spawn.name for spawn in active)
    if style != "listed in a file":
        return [Loop(names, node, style), *others]
    file = Share((values.places.control,), ((config_folder(values.system),), (LISTED,)))
    return [Loop(names, node, "loop", (file,)), *others]


def _ordered(values: Values, found: list[Action]) -> list[Action]:
    """The same actions, in an order by events, if the switch says so."""
    event = values.idioms["event"]
    if event == "timer":
        return [Timer(3.0, tuple(found))]
    if event == "none":
        return found
    chain = list(found)
    starts: list[Action] = []
    if waits_for_start(values.system, values.idioms, event):
        starts = [After(first_label(values.system, values.robot), event.removeprefix("on "), (chain[0],))]
    else:
        starts = [chain[0]]
    for before, action in itertools.pairwise(chain):
        label = before.label if isinstance(before, Node | Execute) else ""
        starts.append(After(label, "exit", (action,)))
    return starts


def first_label(system: System, robot: Robot) -> str:
    """Return the label of the process that a robot's first spawner may wait for."""
    return f"{robot.name}_{'create' if system.is_simulated else 'control_node'}"
