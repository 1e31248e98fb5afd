"""The arguments of generated launch files: those of the robot, its namespace, and those of a simulator."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator, Sequence

from urdfctl.errors import UserError
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.generate.robot.mounting import spawn_height
from urdfctl.startup.records import NamedTuple

NAMESPACE = "namespace"
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


class Argument(NamedTuple):
    """An argument of a launch file, with its default and a description."""

    name: str
    default: str
    about: str = ""


def arguments_of_robot(options: GeneratorOptions, robot: RobotFacts) -> tuple[Argument, ...]:
    """Return the robot's xacro arguments: those that the user gives, and those with a plain default.

    UserError if this form of launch file cannot hold a value.
    """
    given = dict(options.arguments)
    own = {name: value for name, value in robot.arguments.items() if _is_plain(name, value)}
    found = {**own, **given}
    taken = {argument.name for argument in arguments_of_simulator(options, robot, movable=True)}
    python = options.ros == 2 and options.form == "python"  # noqa: PLR2004
    odd = next((f"{name}:={value}" for name, value in given.items() if shlex.quote(value) != value and value), None)
    if odd and not python and options.ros == 2:  # noqa: PLR2004
        raise UserError(f"a launch file in {options.form} cannot pass '{odd}'; use --form python")
    return tuple(Argument(name, value) for name, value in found.items() if name not in (*taken, NAMESPACE))


def _is_plain(name: str, value: str) -> bool:
    return bool(_NAME.fullmatch(name)) and value != "" and shlex.quote(value) == value and "$" not in value


def arguments_of_simulator(options: GeneratorOptions, robot: RobotFacts, *, movable: bool) -> tuple[Argument, ...]:
    """Return the arguments of a simulator: whether to start it, its world, its window, and the pose of the robot in it.

    movable: True if several robots can be in it, each in a namespace of its own.
    """
    return tuple(_of_simulator(options, spawn_height(robot, options), movable=movable))


def namespace_argument(options: GeneratorOptions, robot: RobotFacts) -> Argument:
    """Return the argument with the namespace of the robot."""
    given = {**robot.arguments, **dict(options.arguments)}.get(NAMESPACE, "")
    plain = given.strip("/") if _is_plain(NAMESPACE, given) else ""
    return Argument(NAMESPACE, options.namespace or plain, "namespace of the robot; empty for none")


def _of_simulator(options: GeneratorOptions, height: float, *, movable: bool) -> Iterator[Argument]:
    if movable and options.simulator in ("gz", "gazebo-classic"):
        yield Argument("simulator", "true", "false: it runs already")
    if options.simulator == "gz":
        yield Argument("world", "empty.sdf", "world of the simulator")
        yield Argument("headless", "false", "true: without a window")
    elif options.simulator == "gazebo-classic":
        yield Argument("world", "worlds/empty.world", "world of the simulator")
        yield Argument("gui", "true", "false: without a window")
    if options.simulator in ("gz", "gazebo-classic"):
        for name in ("x", "y", "z", "yaw"):
            value = str(height) if name == "z" else "0.0"
            yield Argument(name, value, f"{name} of the robot in the world, in {'rad' if name == 'yaw' else 'm'}")


def passed(arguments: Sequence[Argument], substitution: str) -> str:
    """Return the arguments of the xacro command in a launch file of XML or YAML."""
    return "".join(f" {argument.name}:=$({substitution} {argument.name})" for argument in arguments)
