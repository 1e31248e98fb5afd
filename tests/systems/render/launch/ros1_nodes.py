"""What is started of a robot in ROS 1: its description and publisher, its driver, its spawners, and Gazebo."""

from __future__ import annotations

from collections.abc import Sequence

from systems.possible import FULL_KEYS, Idioms
from systems.render.actions import Action, Describe, Group, Include, Load, Node, Param, Value, When
from systems.render.arguments import Values
from systems.render.parameters import inline_parameters
from systems.render.places import DESCRIPTION, MANAGER, SPAWNERS, pick
from systems.system import Spawn, System

_TIMEOUTS: dict[str, list[Value]] = {
    "none": [],
    "whole": [("--shutdown-timeout",), ("1",)],
    "beginning": [("--shutdown-time",), ("1",)],
    "with value": [("--shutdown-t=1",)],
}
"""An option of the spawner, as the switch says."""
DEFAULTS = {"mode": "full", "only_states": "false"}
"""The defaults of the arguments that conditions are on, where it is not "true"."""


def simulator(system: System, idioms: Idioms) -> list[Action]:
    """Return what starts Gazebo with an empty world."""
    if idioms["world"] == "programs":
        return [
            Param("/use_sim_time", True),
            Node("gazebo_ros", "gzserver", "gazebo", arguments=(("worlds/empty.world",),)),
            Node("gazebo_ros", "gzclient", "gazebo_gui"),
        ]
    arguments: tuple[tuple[str, Value], ...] = (("paused", ("false",)), ("use_sim_time", ("true",)))
    chosen = arguments if pick(system, "world arguments", (True, False)) else ()
    return [Include("gazebo_ros", "launch/empty_world.launch", chosen, is_external=True)]


def actions_of(role: str, values: Values) -> list[Action]:
    """Return what a role starts for a robot."""
    idioms = values.idioms
    with_robot = idioms["loaded"] == "with robot"
    found = {DESCRIPTION: _description, MANAGER: _driver, SPAWNERS: _spawners}.get(role, lambda _: [])(values)
    loaded = _loads(values) if role == (DESCRIPTION if with_robot else SPAWNERS) else []
    if not (idioms["namespacing"] == "group" and values.robot.namespace):
        return [*loaded, *found]
    if idioms["loading"] == "scope" and values.robot.section == values.robot.namespace:
        return [Group((*loaded, *found), values.namespace)]
    return [*loaded, Group(tuple(found), values.namespace)]


def _namespace(values: Values) -> Value:
    return values.namespace if values.idioms["namespacing"] == "attribute" else ()


def _name(values: Values, name: str) -> str:
    """The name of a node: two robots have different ones, unless they share the file."""
    own = values.idioms["fleet"] == "apart" and (values.system.is_fleet or pick(values.system, "names", (True, False)))
    return f"{values.robot.name}_{name}" if own else name


def _description(values: Values) -> list[Action]:
    namespace = _namespace(values)
    parameter: Value = (*namespace, "/robot_description") if namespace else ("robot_description",)
    publisher = "robot_state_publisher"
    first = [Describe(parameter, values.example)] if values.idioms["described"] == "twice" else []
    found: list[Action] = [
        *first,
        Describe(parameter, values.description),
        Node(publisher, publisher, _name(values, publisher), namespace),
    ]
    if values.system.is_simulated:
        where: tuple[Value, ...] = (("-param",), ("robot_description",))
        if values.idioms["model"] == "file":
            where = (("-file",), values.description.path)
        arguments: tuple[Value, ...] = (("-urdf",), *where, ("-model",), values.model)
        found.append(Node("gazebo_ros", "spawn_model", _name(values, "spawn_model"), namespace, (), arguments))
    return found


def _driver(values: Values) -> list[Action]:
    """A program of its own, with the hardware and the manager in it."""
    package = f"{values.robot.model.removesuffix('_mk2')}_driver"
    return [Node(package, f"{package}_node", _name(values, "driver"), _namespace(values))]


def _loads(values: Values) -> list[Action]:
    """The parameters, in their namespace."""
    idioms, robot = values.idioms, values.robot
    is_own = robot.section == robot.namespace
    section: Value = values.namespace if is_own else (robot.section,)
    in_scope = idioms["namespacing"] != "attribute" and is_own and idioms["loading"] == "scope"
    if idioms["loading"] in FULL_KEYS or in_scope:
        section = ()
    attribute: Value = ("/", *section) if section and idioms["loading"] == "attribute" else ()
    loads: list[Action] = [Load(path, "", attribute) for path in values.files]
    if idioms["parameters"] == "inline":
        loads = [Load((), inline_parameters(values.system, idioms, robot), attribute)]
    if section and not attribute:
        prefix = "" if is_own else "/"
        return [Group(tuple(loads), (prefix, *section) if prefix else section)]
    return loads


def _spawners(values: Values) -> list[Action]:
    form = values.idioms["condition"]
    found = _nodes(values, values.robot.spawned, "controller_spawner")
    if form == "none":
        return found
    name, value = {"expression": ("mode", "full"), "unless": ("only_states", "false")}.get(form, ("spawn_all", "true"))
    when = When(name, value, form)
    others = _nodes(values, values.robot.spawned[:1], "state_spawner", together=True)
    return [Group(tuple(found), (), when), Group(tuple(others), (), When(name, value, form, holds=False))]


def _nodes(values: Values, spawned: Sequence[Spawn], name: str, *, together: bool = False) -> list[Action]:
    """The nodes that spawn some controllers."""
    form = "together" if together else values.idioms["spawners"]
    if form == "each":
        return [_node(values, [spawn], f"spawn_{spawn.name}") for spawn in spawned]
    kinds = [[spawn for spawn in spawned if spawn.active is active] for active in (True, False)]
    names = (name, f"{name}_stopped")
    return [_node(values, group, each, form) for group, each in zip(kinds, names, strict=True) if group]


def _node(values: Values, spawned: Sequence[Spawn], name: str, form: str = "") -> Node:
    robot = values.robot
    main = robot.spawned[1].name if len(robot.spawned) > 1 else ""
    words: list[Value] = [values.controller if spawn.name == main else (spawn.name,) for spawn in spawned]
    program, active = "spawner", spawned[0].active
    if form == "manager program":
        program = "controller_manager"
        words.insert(0, ("spawn",) if active else ("load",))
    elif not active:
        words.append(("--stopped",))
    words[:0] = _TIMEOUTS[values.idioms["timeout"]]
    is_wrong = robot.asked != robot.manager
    namespace: Value = ("/", robot.asked) if is_wrong else _namespace(values)
    if values.idioms["manager option"] == "argument" and (robot.namespace or is_wrong):
        words += [("--namespace",), ("/", robot.asked) if is_wrong else ("/", *values.namespace)]
        namespace = namespace if values.idioms["fleet"] == "shared" else ()
    return Node("controller_manager", program, _name(values, name), namespace, (), tuple(words))
