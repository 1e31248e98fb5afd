"""What launch files do, before it is written in a language: actions, and the values that they are given."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass
from typing import Any


@dataclass(frozen=True)
class Arg:
    """The value of a launch argument."""

    name: str


@dataclass(frozen=True)
class Variable:
    """The value of an environment variable, or a text if there is none."""

    name: str
    default: str


@dataclass(frozen=True)
class Name:
    """The variable of the loop around."""

    name: str = "name"


@dataclass(frozen=True)
class Share:
    """A path in the share folder of a package."""

    package: Value
    parts: tuple[Value, ...]


Value = tuple["str | Arg | Name | Share | Variable | Description", ...]
"""Pieces that are joined."""


@dataclass(frozen=True)
class Description:
    """The text of a robot description. is_plain: whether it needs no xacro."""

    path: Value
    mappings: tuple[tuple[str, Value], ...] = ()
    is_plain: bool = False


@dataclass(frozen=True)
class ParamFile:
    """A file of parameters.

    rewritten: how, "" for as it is: "replaced" (ReplaceString) or "rewritten" (RewrittenYaml), for a namespace;
        or "written" by the launch file, from a template.
    """

    path: Value
    rewritten: str = ""
    namespace: Value = ()


@dataclass(frozen=True)
class Param:
    """A parameter."""

    name: str
    value: Description | bool | int | str


@dataclass(frozen=True)
class When:
    """A condition on an argument: it has a value, or has not. form: a position of the switch "condition"."""

    arg: str
    value: str
    form: str
    holds: bool = True


@dataclass(frozen=True)
class Node:
    """A node. label: by which an event handler refers to it."""

    package: str
    executable: str
    name: str = ""
    namespace: Value = ()
    parameters: tuple[Param | ParamFile, ...] = ()
    arguments: tuple[Value, ...] = ()
    remaps: tuple[tuple[str, str], ...] = ()
    label: str = ""
    when: When | None = None


@dataclass(frozen=True)
class Execute:
    """A command."""

    words: tuple[Value, ...]
    label: str = ""
    when: When | None = None


@dataclass(frozen=True)
class Include:
    """An included launch file: of this workspace by its stem, of another package by its path, or by any path."""

    package: str
    file: str
    arguments: tuple[tuple[str, Value], ...] = ()
    is_external: bool = False
    path: Value = ()


@dataclass(frozen=True)
class Group:
    """Actions in a namespace, under a condition, or both."""

    actions: tuple[Action, ...]
    namespace: Value = ()
    when: When | None = None


@dataclass(frozen=True)
class Timer:
    """Actions some seconds later."""

    seconds: float
    actions: tuple[Action, ...]


@dataclass(frozen=True)
class After:
    """Actions when a process has ended or started. event: "exit" or "start"."""

    label: str
    event: str
    actions: tuple[Action, ...]


@dataclass(frozen=True)
class Loop:
    """A node for each of some names. style: "comprehension" or "loop". listed: the file that has the names."""

    names: tuple[str, ...]
    node: Node
    style: str
    listed: Value = ()


@dataclass(frozen=True)
class Describe:
    """A parameter of ROS 1 with a description."""

    name: Value
    description: Description


@dataclass(frozen=True)
class Load:
    """Parameters of ROS 1, of a file or written in the launch file. namespace: of the tag, if it has one."""

    path: Value
    text: str = ""
    namespace: Value = ()


Action = Node | Execute | Include | Group | Timer | After | Loop | Param | Describe | Load


@dataclass
class LaunchFile:
    """A launch file.

    stem: its name without what the language adds.
    declared: its arguments, with their defaults; None for one that must be given.
    is_set: whether those with a default are set, so that nobody can give another value.
    """

    package: str
    stem: str
    language: str
    actions: tuple[Action, ...]
    declared: tuple[tuple[str, Value | None], ...] = ()
    is_set: bool = False


def parts_of(thing: Any) -> Iterator[Any]:
    """Yield everything in an action, a value or a tuple of them, outermost first."""
    yield thing
    if isinstance(thing, tuple):
        for part in thing:
            yield from parts_of(part)
    elif is_dataclass(thing):
        for field in fields(thing):
            yield from parts_of(getattr(thing, field.name))


def args_in(thing: Any) -> list[str]:
    """Return the names of the arguments that something depends on, in order."""
    found = (
        part.name if isinstance(part, Arg) else part.arg for part in parts_of(thing) if isinstance(part, Arg | When)
    )
    return list(dict.fromkeys(found))


def packages_in(thing: Any) -> set[str]:
    """Return the packages that something names."""
    found = {part.package for part in parts_of(thing) if isinstance(part, Node | Include) and part.package}
    shares = (part.package for part in parts_of(thing) if isinstance(part, Share))
    return found | {piece for package in shares for piece in package if isinstance(piece, str)}
