"""What replaces what from one ROS 2 distro to a later one, as data: names, and parameters of controllers."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.store import moves_data
from urdfctl.startup.records import NamedTuple


class MovedNames(NamedTuple):
    """Names that were replaced by others.

    since: the first distro in which the new names are right.
    parts: the parts of a package that may have them: urdf, yaml, launch, manifest.
    names: the new name of each old one.
    is_pattern: whether the old names are regular expressions for a part of a value.
    element: the XML element whose attributes have them; `*` if they are names of elements; empty for any value.
    """

    since: str
    authority: str
    parts: tuple[str, ...]
    names: Mapping[str, str]
    is_pattern: bool = False
    element: str = ""


class When(NamedTuple):
    """A condition of a move.

    param: the parameter that it is about; the moved one if empty.
    value: it must have this value, unless `is_set`: then it must be set.
    or_absent: whether the condition also holds if the parameter is not set.
    """

    param: str = ""
    value: object = None
    is_set: bool = False
    or_absent: bool = False


class Move(NamedTuple):
    """What becomes of one parameter.

    controllers: the types of controllers that have it; `controller_manager` for the manager, `*` for all controllers.
    name: its dotted name, in which `<joints>` stands for any element.
    when: the condition, if any; of several moves of a parameter the first whose condition holds is made.
    becomes: the parameters that take its place, each with its value: `same`, `negative`, or a literal. Empty: dropped.
    only_set: whether only those that are set already get their value.
    is_default: whether the parameter is not set, and gets the default of earlier distros.
    todo: what is left to the user.
    since: the first distro in which it is right.
    """

    controllers: tuple[str, ...]
    name: str
    since: str
    authority: str
    when: When | None = None
    becomes: Mapping[str, object] = {}
    only_set: bool = False
    is_default: bool = False
    todo: str = ""

    def is_for(self, kind: str) -> bool:
        """Return whether the parameter is one of a type of controllers."""
        return kind in self.controllers or ("*" in self.controllers and kind != MANAGER)


MANAGER = "controller_manager"
"""The type of the controller manager itself."""


@lru_cache(maxsize=1)
def name_moves() -> tuple[MovedNames, ...]:
    """Return the names that were replaced."""
    return tuple(
        MovedNames(
            since=entry["since"],
            authority=entry["authority"],
            parts=tuple(entry["in"]),
            names=entry["names"],
            is_pattern=entry.get("pattern", False),
            element=entry.get("element", ""),
        )
        for entry in moves_data()["names"]
    )


@lru_cache(maxsize=1)
def parameter_moves() -> tuple[Move, ...]:
    """Return what becomes of parameters, in the order in which the moves of one parameter are tried."""
    return tuple(_move(group, entry) for group in moves_data()["parameters"] for entry in group["moves"])


def replacement_in_words(kind: str, name: str, distro: str) -> str | None:
    """Return what takes the place of a controller's parameter in a distro, for a message; None if no move says it.

    name: the parameter's name in the catalogue, with placeholders.
    """
    order = ROS2.index
    moves = [move for move in parameter_moves() if move.is_for(kind) and move.name == name and not move.is_default]
    moves = [move for move in moves if distro in ROS2 and order(move.since) <= order(distro)]
    texts = [" and ".join(in_words(new, value) for new, value in move.becomes.items()) for move in moves]
    wanted = [(text, move) for text, move in zip(texts, moves, strict=True) if text]
    return " or ".join(f"{text}{_condition(move.when)}" for text, move in wanted) or None


def in_words(name: str, value: object) -> str:
    """Return a parameter with the value that a move gives it: the name alone if that is the old value."""
    return name if value == "same" else f"{name}: {'-value' if value == 'negative' else as_yaml(value)}"


def as_yaml(value: object) -> str:
    """Return a literal of the moves as YAML."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str) and not re.fullmatch(r"[.\w]+", value):
        return f'"{value}"'
    return str(value)


def _condition(when: When | None) -> str:
    """A condition in words, for a message."""
    if when is None:
        return ""
    if when.is_set:
        return f" (if {when.param} is set)"
    return f" (if {when.param or 'it'} is {as_yaml(when.value)})"


def _move(group: Mapping[str, Any], entry: Mapping[str, Any]) -> Move:
    becomes = entry.get("becomes", {})
    when = entry.get("when")
    return Move(
        controllers=tuple(group["controllers"]),
        name=entry.get("from") or entry["absent"],
        since=group["since"],
        authority=group["authority"],
        when=_when(when) if when else None,
        becomes={becomes: "same"} if isinstance(becomes, str) else becomes,
        only_set=entry.get("only_set", False),
        is_default="absent" in entry,
        todo=entry.get("todo", ""),
    )


def _when(entry: Mapping[str, Any]) -> When:
    return When(entry.get("param", ""), entry.get("is"), entry.get("is_set", False), entry.get("or_absent", False))
