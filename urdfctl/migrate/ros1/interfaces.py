"""What the hardware interfaces of ROS 1 are in ROS 2, as names of command and state interfaces."""

from __future__ import annotations

import re
from collections.abc import Collection

from urdfctl.startup.records import NamedTuple

_COMMANDS = {
    "EffortJointInterface": ("effort",),
    "VelocityJointInterface": ("velocity",),
    "PositionJointInterface": ("position",),
    "PosVelJointInterface": ("position", "velocity"),
    "PosVelAccJointInterface": ("position", "velocity", "acceleration"),
    "JointStateInterface": (),
}
_PACKAGE = "hardware_interface/"
_ENDING = "JointInterface"
_EXPRESSION = r"\$\{([^{}]+)\}"
_ARGUMENT = r"\$\(arg ([^()]+)\)"
_LAST_PART = ".split('/')[-1]"
_PLAIN = f".replace('{_ENDING}', '').lower()"


class CommandNames(NamedTuple):
    """The command interfaces that the text of a `<hardwareInterface>` means.

    names: their names as a description writes them, maybe as expressions of xacro.
    arguments: the xacro arguments that the expressions read as properties: the names of property and argument.
    """

    names: tuple[str, ...]
    arguments: tuple[tuple[str, str], ...] = ()


def plain_name(interface: str) -> str:
    """Return the name of a hardware interface without its package."""
    return interface.strip().removeprefix(_PACKAGE)


def commands_of(interface: str) -> tuple[str, ...] | None:
    """Return the command interfaces for a hardware interface of ROS 1; None if it is unknown."""
    return _COMMANDS.get(plain_name(interface))


def command_names(written: str, evaluated: Collection[str]) -> CommandNames | None:
    """Return the command interfaces for the text of a `<hardwareInterface>`; None if they cannot be known.

    written: the text in the file, where it may be an expression.
    evaluated: the values that it has in the robots; none if no robot uses it.
    """
    known = commands_of(written)
    if known is not None:
        return CommandNames(known)
    meant = {commands_of(value) for value in evaluated}
    if None in meant or any(len(names or ()) != 1 for names in meant):
        return None
    return _as_expression(plain_name(written))


def _as_expression(text: str) -> CommandNames | None:
    """The name that follows from an expression's value: `effort` if it is `EffortJointInterface`."""
    arguments: list[tuple[str, str]] = []
    argument = re.fullmatch(f"{_ARGUMENT}({_ENDING})?", text)
    if argument:
        name = f"{re.sub(r'[^A-Za-z0-9_]', '_', argument[1].strip())}_argument"
        arguments.append((name, argument[1].strip()))
        text = f"${{{name}}}{argument[2] or ''}"
    whole = re.fullmatch(_EXPRESSION, text)
    part = re.fullmatch(f"{_EXPRESSION}{_ENDING}", text)
    if whole:
        return CommandNames((f"${{{_grouped(whole[1])}{_LAST_PART}{_PLAIN}}}",), tuple(arguments))
    if part:
        return CommandNames((f"${{{_grouped(part[1])}.lower()}}",), tuple(arguments))
    return None


def _grouped(expression: str) -> str:
    expression = expression.strip()
    return expression if expression.isidentifier() else f"({expression})"


def states_of(commands: Collection[str]) -> tuple[str, ...]:
    """Return the state interfaces of a joint with these command interfaces."""
    return ("position", "velocity", "effort") if "effort" in commands else ("position", "velocity")
