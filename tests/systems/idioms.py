"""The idioms in which a system is written: independent switches, of which each has a plain position."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from random import Random
from typing import NamedTuple

from systems.system import GZ, System

Idioms = dict[str, str]
"""The position of each switch."""
_PLAIN = 0.45  # how often a switch stays in its plain position: combinations of a few idioms are what fails


class Switch(NamedTuple):
    """A choice of idioms.

    positions: the plain one first.
    allowed: which positions a system can have, given those of the switches before.
    """

    positions: tuple[str, ...]
    allowed: Callable[[System, Idioms, str], bool] = lambda _system, _idioms, _position: True


def drawn(system: System) -> Idioms:
    """Return random positions for a system."""
    random = Random(f"idioms {system.seed}")  # noqa: S311 (nothing secret)

    def choose(_name: str, positions: list[str]) -> str:
        return positions[0] if random.random() < _PLAIN else random.choice(positions)

    return _chosen(system, choose)


def settled(system: System, wanted: Mapping[str, str]) -> Idioms:
    """Return wanted positions as far as they are possible together, and plain ones for the others."""
    return _chosen(system, lambda name, positions: _wanted(wanted.get(name, ""), positions))


def _wanted(position: str, positions: list[str]) -> str:
    return position if position in positions else positions[0]


def _chosen(system: System, choose: Callable[[str, list[str]], str]) -> Idioms:
    chosen: dict[str, str] = {}
    for name, switch in SWITCHES.items():
        positions = [
            position
            for index, position in enumerate(switch.positions)
            if index == 0 or switch.allowed(system, chosen, position)
        ]
        chosen[name] = choose(name, positions)
    return chosen


def is_plain(name: str, position: str) -> bool:
    """Return whether a switch is in its plain position."""
    return SWITCHES[name].positions[0] == position


# -- what is possible together ------------------------------------------------------------------------------------


def _ros2(system: System, _idioms: Idioms, _position: str) -> bool:
    return system.generation == 2 and not system.moveit


def _not_moveit(system: System, _idioms: Idioms, _position: str) -> bool:
    return not system.moveit


def _moveit(system: System, _idioms: Idioms, _position: str) -> bool:
    return system.moveit


def _has_inner(system: System, idioms: Idioms, _position: str) -> bool:
    return _not_moveit(system, idioms, "") and idioms["depth"] != "flat"


def _inner_language(system: System, idioms: Idioms, _position: str) -> bool:
    return _ros2(system, idioms, "") and idioms["depth"] != "flat"


def _has_python(system: System, idioms: Idioms, _position: str) -> bool:
    """Whether the file that holds the nodes is in Python."""
    return _ros2(system, idioms, "") and idioms["top" if idioms["depth"] == "flat" else "inner"] == "python"


def _any_python(system: System, idioms: Idioms, _position: str) -> bool:
    return _ros2(system, idioms, "") and "python" in (idioms["top"], _inner_of(idioms))


def _inner_of(idioms: Idioms) -> str:
    return idioms["top"] if idioms["depth"] == "flat" else idioms["inner"]


def _source(system: System, _idioms: Idioms, position: str) -> bool:
    """A plain URDF, and one that is made when the package is built, has no arguments: robots that share it have the
    same names. A plain URDF does not have the path of a file either."""
    if position == "built" and system.is_simulated and any(robot.namespace for robot in system.robots):
        return False
    return position == "macros" or not (
        system.moveit
        or (position == "urdf" and system.is_simulated and system.generation == 2)
        or any(robot.prefix for robot in system.robots)
        or (system.is_simulated and system.is_fleet)
    )


_TEXTS = ("urdf", "built")
"""Sources of which launch files find a text."""


def _shared(system: System, idioms: Idioms, _position: str) -> bool:
    """Files that are included once for each robot: all that differs is in their arguments."""
    named = all(robot.namespace for robot in system.robots)
    if not (system.is_fleet and named and idioms["depth"] != "flat" and not system.moveit):
        return False
    first, second = system.robots
    same = (first.model, first.joints, first.spawned, first.manager, first.asked)
    return same == (second.model, second.joints, second.spawned, second.manager, second.asked)


def _argued(system: System, idioms: Idioms, position: str) -> bool:
    if system.moveit or (system.is_fleet and idioms["fleet"] == "apart"):
        return False
    if idioms["fleet"] == "shared":
        return True
    robot = system.robots[0]
    possible = {"namespace": bool(robot.namespace), "prefix": bool(robot.prefix) and idioms["source"] not in _TEXTS}
    return possible.get(position, True)


def _passing(system: System, idioms: Idioms, position: str) -> bool:
    if idioms["fleet"] == "shared":
        return position == "required"
    return _has_inner(system, idioms, "") and idioms["argued"] != "nothing"


def _description(system: System, idioms: Idioms, position: str) -> bool:
    """A file without xacro can be read; what xacro's Python functions expand depends on no launch argument."""
    if not _has_python(system, idioms, ""):
        return False
    if position == "perform":
        return idioms["values"] == "perform"
    is_known = idioms["values"] == "perform" or (idioms["argued"] == "nothing" and idioms["fleet"] == "apart")
    if position == "open":
        return idioms["source"] in _TEXTS and is_known
    return position not in ("process_file", "process_doc", "function", "module") or is_known


def _opaque(system: System, idioms: Idioms, _position: str) -> bool:
    """What is done later has neither the namespace of a group that is left, nor the arguments of another include."""
    scoped = idioms["namespacing"] == "group around include" or idioms["fleet"] == "shared"
    return _has_python(system, idioms, "") and idioms["values"] == "perform" and not scoped


def _address(system: System, idioms: Idioms, _position: str) -> bool:
    """An argument of the description that has no value until the robot is started."""
    if idioms["source"] in _TEXTS or system.moveit or idioms["fleet"] == "shared":
        return False
    return idioms["values"] == "perform" or idioms["description"] not in _EXPANDED


_EXPANDED = ("process_file", "process_doc", "function", "module", "open")
"""How a description is made by Python itself."""


def _hardware(system: System, idioms: Idioms, _position: str) -> bool:
    """An argument chooses between a simulator and hardware."""
    one = system.generation == 2 and not system.moveit and not system.is_fleet
    known = idioms["values"] == "perform" or idioms["description"] not in _EXPANDED
    return one and known and idioms["source"] not in _TEXTS and system.robots[0].manager == "controller_manager"


def _planner(system: System, idioms: Idioms, _position: str) -> bool:
    one = system.generation == 2 and not system.moveit and not system.is_fleet
    return one and idioms["source"] not in _TEXTS and idioms["description"] not in ("function", "module", "open")


def _model(system: System, idioms: Idioms, position: str) -> bool:
    """What is put into the simulator: by Gazebo's program for ROS 1 a file, by that for Gazebo Sim a text."""
    if position == "file":
        return system.generation == 1 and system.is_simulated and idioms["source"] in _TEXTS
    wrapped = idioms["description"] in ("parameter_value", "find_executable")
    return system.simulator == GZ and _has_python(system, idioms, "") and not wrapped


def _described(system: System, idioms: Idioms, _position: str) -> bool:
    """The parameter is set twice, and the last one wins."""
    return system.generation == 1 and idioms["order"] == "natural"


def _namespaced(system: System, idioms: Idioms, position: str) -> bool:
    if not any(robot.namespace for robot in system.robots) or system.moveit:
        return False
    return position != "group around include" or _has_inner(system, idioms, "")


def _sections(system: System, idioms: Idioms, position: str) -> bool:
    """A file is rewritten for a node that the launch file starts; a plugin reads it as it is."""
    if system.generation == 1 or system.moveit:
        return False
    if position == "wildcard":
        return not _is_section_wrong(system)
    if position == "rooted":
        return not any(robot.section for robot in system.robots)
    if not all(robot.namespace for robot in system.robots) or _is_section_wrong(system):
        return False
    if idioms["hardware"] == "chosen":
        return position == "nested"
    return position == "nested" or (not system.simulator and _has_python(system, idioms, ""))


def _ros1(system: System, _idioms: Idioms, _position: str) -> bool:
    return system.generation == 1


def _loading(system: System, idioms: Idioms, position: str) -> bool:
    if position == "key" and idioms["namespacing"] == "group around include":
        return False
    return system.generation == 1 and all(robot.section for robot in system.robots)


def _is_section_wrong(system: System) -> bool:
    return any(robot.section != robot.namespace for robot in system.robots)


def _parameters(system: System, idioms: Idioms, position: str) -> bool:
    if system.moveit:
        return False
    if position == "dictionary":
        untyped = any(not one.typed for robot in system.robots for one in robot.controllers)
        return _real_ros2(system) and idioms["hardware"] == "fixed" and not untyped and not _is_section_wrong(system)
    if position == "written":  # by the launch file, from a template
        made = _has_python(system, idioms, "") and idioms["values"] == "perform" and idioms["sections"] == "full name"
        fixed = idioms["hardware"] == "fixed" and not system.is_fleet and idioms["argued"] not in ("controllers", "all")
        return made and fixed and _real_ros2(system)
    if position == "common":  # one file for several robots
        return system.is_fleet and system.generation == 2 and idioms["sections"] == "full name"
    if position == "inline":
        return system.generation == 1
    return system.generation == 1 or idioms["sections"] not in ("replaced", "rewritten")


def _real_ros2(system: System) -> bool:
    return system.generation == 2 and not system.simulator and not system.moveit


LOOPS = ("comprehension", "loop", "function", "listed in a file")
"""How the names of controllers are looped over."""


def _spawners(system: System, idioms: Idioms, position: str) -> bool:
    if system.moveit:
        return False
    if position == "listed in a file" and system.is_fleet:
        return False
    if position in LOOPS:
        return _has_python(system, idioms, "")
    if position == "command line":
        return system.generation == 2
    return position != "manager program" or system.generation == 1


def _manager_option(system: System, idioms: Idioms, position: str) -> bool:
    """The plain one is the absolute name; without any, the spawner looks for controller_manager in its namespace."""
    if system.generation == 1:
        return position == "argument" and idioms["spawners"] != "manager program"
    if system.moveit or position == "argument":
        return False
    if position == "none":
        plain = all(robot.asked == "controller_manager" for robot in system.robots)
        return plain and idioms["spawners"] != "command line"
    return position != "relative" or idioms["spawners"] != "command line"


def _param_file(system: System, idioms: Idioms, _position: str) -> bool:
    if idioms["parameters"] == "written":
        return False
    possible = idioms["spawners"] != "command line" and idioms["sections"] not in ("nested", "replaced", "rewritten")
    return _ros2(system, idioms, "") and possible and not _is_section_wrong(system)


def _around(system: System, idioms: Idioms, _position: str) -> bool:
    return not system.moveit and idioms["split"] == "one start"


def _event(system: System, idioms: Idioms, position: str) -> bool:
    if idioms["namespacing"] != "attribute" or idioms["fleet"] == "shared":
        return False  # as of what is called later
    if position == "timer":
        return _ros2(system, idioms, "")
    if not _has_python(system, idioms, "") or idioms["spawners"] in LOOPS:
        return False
    in_a_row = position == "on exit" and idioms["spawners"] in ("each", "command line")
    return in_a_row or waits_for_start(system, idioms, position)


def waits_for_start(system: System, idioms: Idioms, event: str) -> bool:
    """Return whether the first spawner waits for what is started beside it in the same file: by "on exit" for the
    program that puts the robot into the simulator, by "on start" for the manager."""
    beside = idioms["depth"] == "flat" and idioms["split"] in ("one start", "manager apart")
    return beside and system.is_simulated is (event == "on exit")


def _condition(system: System, idioms: Idioms, position: str) -> bool:
    if position == "python":
        return _has_python(system, idioms, "") and idioms["values"] == "perform"
    if position == "substitution":
        return _has_python(system, idioms, "") and system.distro != "humble"
    if position == "equals":
        return _has_python(system, idioms, "") and system.distro == "humble"
    return not system.moveit


def _manager_description(system: System, idioms: Idioms, position: str) -> bool:
    """Before jazzy the manager reads `~/robot_description`; since kilted it has no such parameter."""
    return (
        _real_ros2(system)
        and system.distro in {"topic": ("jazzy", "kilted"), "parameter": ("humble", "jazzy")}[position]
    )


def _build(system: System, idioms: Idioms, _position: str) -> bool:
    return _ros2(system, idioms, "") and idioms["source"] != "built"


def _distractor(_system: System, idioms: Idioms, position: str) -> bool:
    """A distro that the user names is meant for everything."""
    return position != "other generation" or idioms["evidence"] != "option"


SWITCHES = {
    "depth": Switch(("flat", "parts", "nested"), _not_moveit),
    "top": Switch(("python", "xml", "yaml"), _ros2),
    "inner": Switch(("python", "xml", "yaml"), _inner_language),
    "suffix": Switch((".launch", "_launch"), _ros2),
    "source": Switch(("xacro", "macros", "urdf", "built"), _source),
    "fleet": Switch(("apart", "shared"), _shared),
    "argued": Switch(
        ("nothing", "controllers", "description", "namespace", "prefix", "spawned", "package", "all"), _argued
    ),
    "passing": Switch(("default", "forwarded", "overridden", "required"), _passing),
    "order": Switch(("natural", "backward"), _not_moveit),
    "values": Switch(("substitutions", "perform"), _has_python),
    "layout": Switch(("list", "variables", "add_action"), _any_python),
    "paths": Switch(
        ("find_package_share", "joined", "share_directory", "pathlib", "share_path", "find", "plus", "file"),
        _any_python,
    ),
    "description": Switch(
        (
            "parameter_value",
            "command",
            "find_executable",
            "perform",
            "process_file",
            "process_doc",
            "function",
            "module",
            "open",
        ),
        _description,
    ),
    "wrapped": Switch(("nothing", "where used"), _has_python),
    "address": Switch(("none", "required"), _address),
    "hardware": Switch(("fixed", "chosen"), _hardware),
    "planner": Switch(("none", "other arguments"), _planner),
    "described": Switch(("once", "twice"), _described),
    "model": Switch(("topic", "text", "file"), _model),
    "namespacing": Switch(("attribute", "group", "group around include"), _namespaced),
    "opaque": Switch(("at once", "timer", "event"), _opaque),
    "sections": Switch(("full name", "rooted", "wildcard", "nested", "replaced", "rewritten"), _sections),
    "loaded": Switch(("with spawners", "with robot"), _ros1),
    "loading": Switch(("scope", "attribute", "key"), _loading),
    "parameters": Switch(("one file", "several files", "common", "dictionary", "inline", "written"), _parameters),
    "spawners": Switch(
        (
            "together",
            "each",
            "comprehension",
            "loop",
            "function",
            "listed in a file",
            "command line",
            "manager program",
        ),
        _spawners,
    ),
    "manager option": Switch(("absolute", "none", "relative", "argument"), _manager_option),
    "param file": Switch(("none", "given"), _param_file),
    "split": Switch(("one start", "spawners apart", "manager apart", "three starts"), _not_moveit),
    "around": Switch(("nothing", "rviz", "plain", "handed on"), _around),
    "event": Switch(("none", "on exit", "on start", "timer"), _event),
    "condition": Switch(("none", "if", "unless", "expression", "equals", "substitution", "python"), _condition),
    "manager description": Switch(("remap", "parameter", "topic"), _manager_description),
    "packages": Switch(("one", "two", "three"), _not_moveit),
    "build": Switch(("cmake", "python"), _build),
    "demo": Switch(("generated", "by hand", "own nodes"), _moveit),
    "world": Switch(("included", "programs"), lambda system, _idioms, _position: system.is_simulated),
    "evidence": Switch(
        ("option", "nothing", "dockerfile", "workflow", "devcontainer", "repos", "readme", "several"),
    ),
    "distractor": Switch(
        (
            "none",
            "unlaunched robot",
            "old copy",
            "tests",
            "other generation",
            "vendored",
            "parts",
            "calibration",
            "backups",
        ),
        _distractor,
    ),
}
"""All switches, each after those that it depends on."""
