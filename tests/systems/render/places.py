"""Where things are in the workspace: packages, files, and which start starts what."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import NamedTuple, TypeVar

from systems.possible import Idioms
from systems.system import Robot, System

SIMULATOR, DESCRIPTION, MANAGER, SPAWNERS = "simulator", "description", "manager", "spawners"
Choice = TypeVar("Choice")


def pick(system: System, what: str, choices: Sequence[Choice]) -> Choice:
    """Return one of some choices that mean the same: always the same one for a seed, whatever else is chosen."""
    return Random(f"{what} {system.seed}").choice(choices)  # noqa: S311 (nothing secret)


class Places(NamedTuple):
    """The packages of a workspace: with the description, with the parameters, and with the launch files to start."""

    description: str
    control: str
    bringup: str

    @property
    def packages(self) -> tuple[str, ...]:
        """Their names, each once."""
        return tuple(dict.fromkeys(self))


def places_of(system: System, idioms: Idioms) -> Places:
    """Return the packages of a workspace."""
    name = system.robots[0].model
    if idioms["packages"] == "one":
        return Places(*[pick(system, "package", (name, f"{name}_robot", f"{name}_bringup"))] * 3)
    bringup = pick(system, "bringup", (f"{name}_bringup", f"{name}_launch", f"{name}_start"))
    if idioms["packages"] == "two":
        return Places(f"{name}_description", bringup, bringup)
    return Places(f"{name}_description", pick(system, "control", (f"{name}_control", f"{name}_config")), bringup)


def roles_of(system: System) -> tuple[str, str, str]:
    """Return what is started, in order."""
    return (SIMULATOR, DESCRIPTION, SPAWNERS) if system.is_simulated else (DESCRIPTION, MANAGER, SPAWNERS)


def starts_of(system: System, idioms: Idioms) -> list[tuple[str, tuple[str, ...]]]:
    """Return the launch files that somebody starts, by name, with what they start."""
    roles = roles_of(system)
    first = pick(
        system, "first", ("gazebo", "simulation", "world") if system.is_simulated else ("robot", "state", "rsp")
    )
    last = pick(system, "last", ("control", "controllers", "spawn"))
    whole = pick(system, "whole", ("bringup", "robot", "start", "main"))
    cuts = {
        "one start": [(whole, roles)],
        "spawners apart": [(first, roles[:2]), (last, roles[2:])],
        "manager apart": [(first, roles[:1]), (last, roles[1:])],
        "three starts": [
            (first, roles[:1]),
            (pick(system, "middle", ("load", "drivers")), roles[1:2]),
            (last, roles[2:]),
        ],
    }
    return cuts[idioms["split"]]


def description_name(system: System, idioms: Idioms, robot: Robot) -> str:
    """Return the name of a robot's description, without its folder."""
    if is_text(idioms):
        return f"{robot.model}.urdf"
    return pick(system, "description", (f"{robot.model}.urdf.xacro", f"{robot.model}.xacro"))


def source_name(system: System, idioms: Idioms, robot: Robot) -> str:
    """Return the name of the file that a robot's description is written in: it may be made from it when it is built."""
    return f"{robot.model}.urdf.xacro" if idioms["source"] == "built" else description_name(system, idioms, robot)


def is_text(idioms: Idioms) -> bool:
    """Return whether launch files find the description as text, that xacro does not have to expand."""
    return idioms["source"] in ("urdf", "built")


def config_folder(system: System) -> str:
    """Return the name of the folder for parameters."""
    return pick(system, "config folder", ("config", "config", "params"))


def parameter_names(system: System, idioms: Idioms, robot: Robot) -> tuple[str, ...]:
    """Return the names of a robot's files of parameters, without their folder: the manager's first if it has one."""
    plain = pick(
        system,
        "yaml",
        ("controllers", "ros2_controllers", "control") if system.generation == 2 else ("controllers", "control"),
    )
    own = f"{robot.name}_{plain}" if system.is_fleet and idioms["parameters"] != "common" else plain
    if idioms["parameters"] == "inline":
        return ()
    if idioms["parameters"] == "written":
        return (f"{own}.yaml.in",)
    return (f"{own}_types.yaml", f"{own}.yaml") if idioms["parameters"] == "several files" else (f"{own}.yaml",)
