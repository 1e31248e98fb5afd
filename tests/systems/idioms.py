"""The idioms in which a system is written: independent switches, of which each has a plain position."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from random import Random
from typing import NamedTuple

from systems import possible
from systems.possible import Idioms
from systems.system import System

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


SWITCHES = {
    "depth": Switch(("flat", "parts", "nested"), possible.not_moveit),
    "top": Switch(("python", "xml", "yaml"), possible.ros2),
    "inner": Switch(("python", "xml", "yaml"), possible.inner_language),
    "suffix": Switch((".launch", "_launch"), possible.ros2),
    "source": Switch(("xacro", "macros", "urdf", "built"), possible.source),
    "fleet": Switch(("apart", "shared"), possible.shared),
    "argued": Switch(
        ("nothing", "controllers", "description", "namespace", "prefix", "spawned", "package", "all"), possible.argued
    ),
    "passing": Switch(("default", "forwarded", "overridden", "required"), possible.passing),
    "defaults": Switch(("written", "environment", "set"), possible.defaults),
    "order": Switch(("natural", "backward"), possible.not_moveit),
    "values": Switch(("substitutions", "perform"), possible.has_python),
    "layout": Switch(("list", "variables", "add_action"), possible.any_python),
    "paths": Switch(
        ("find_package_share", "joined", "share_directory", "pathlib", "share_path", "find", "plus", "file"),
        possible.any_python,
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
        possible.description,
    ),
    "wrapped": Switch(("nothing", "where used"), possible.has_python),
    "address": Switch(("none", "required"), possible.address),
    "hardware": Switch(("fixed", "chosen"), possible.hardware),
    "described": Switch(("once", "twice"), possible.described),
    "model": Switch(("topic", "text", "file"), possible.model),
    "namespacing": Switch(("attribute", "group", "group around include"), possible.namespaced),
    "opaque": Switch(("at once", "timer", "event"), possible.opaque),
    "sections": Switch(("full name", "rooted", "wildcard", "nested", "replaced", "rewritten"), possible.sections),
    "loaded": Switch(("with spawners", "with robot"), possible.ros1),
    "loading": Switch(("scope", "attribute", "key", "full names"), possible.loading),
    "parameters": Switch(
        ("one file", "several files", "common", "dictionary", "inline", "written"), possible.parameters
    ),
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
        possible.spawners,
    ),
    "manager option": Switch(("absolute", "none", "relative", "argument"), possible.manager_option),
    "timeout": Switch(("none", "whole", "beginning", "with value"), possible.timeout),
    "param file": Switch(("none", "given"), possible.param_file),
    "split": Switch(("one start", "spawners apart", "manager apart", "three starts"), possible.not_moveit),
    "planner": Switch(("none", "other arguments", "with spawners"), possible.planner),
    "around": Switch(("nothing", "rviz", "plain", "handed on"), possible.around),
    "told": Switch(("nowhere", "readme", "document", "script"), possible.told),
    "event": Switch(("none", "on exit", "on start", "timer"), possible.event),
    "condition": Switch(("none", "if", "unless", "expression", "equals", "substitution", "python"), possible.condition),
    "reduced": Switch(("nothing", "around"), possible.reduced),
    "manager description": Switch(("remap", "parameter", "topic", "webots"), possible.manager_description),
    "packages": Switch(("one", "two", "three"), possible.not_moveit),
    "build": Switch(("cmake", "python"), possible.build),
    "demo": Switch(("generated", "by hand", "own nodes", "merged"), possible.moveit),
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
            "namesakes",
            "started elsewhere",
        ),
        possible.distractor,
    ),
}
"""All switches, each after those that it depends on."""
