"""Chains of calls that begin with a MoveItConfigsBuilder, and the file with MoveIt's controllers that one reads."""

from __future__ import annotations

import os

from urdfctl.source.disk.gate import names_in
from urdfctl.source.launch.terms import Called, Member, OneOf, Term

_LONGEST_CHAIN = 30
_CHOICES = ("moveit", "moveit2")
_ENDING = "_controllers.yaml"


def chain_of(term: Term | None) -> tuple[Called, dict[str, Called]] | None:
    """Return the MoveItConfigsBuilder at the start of a chain of calls, with the last call of each method on it; None
    if there is none."""
    calls: dict[str, Called] = {}
    for _ in range(_LONGEST_CHAIN):
        if isinstance(term, Called) and term.short == "MoveItConfigsBuilder":
            return term, calls
        if isinstance(term, Called):
            calls.setdefault(term.name, term)
        if isinstance(term, OneOf):
            return None
        term = term.of if isinstance(term, (Called, Member)) else None
    return None


def usual_controllers(package: str, robot: str) -> str | None:
    """Return the file with MoveIt's controllers that is read if none is named; None if the builder cannot choose one.

    robot: the name that the builder is given (moveit_configs_utils, moveit_configs_builder.py, trajectory_execution()).
    """
    folder = os.path.join(package, "config")
    names = [name.removesuffix(_ENDING) for name in controllers_in(folder)]
    chosen = names[0] if len(names) == 1 else next((n for n in (*_CHOICES, robot) if n in names), None)
    return os.path.join(folder, chosen + _ENDING) if chosen else None


def controllers_in(folder: str) -> list[str]:
    """Return the names of the files with MoveIt's controllers in a folder."""
    return [name for name in listed_names(folder) if name.endswith(_ENDING)]


def listed_names(folder: str) -> list[str]:
    """Return the names in a folder; none if it cannot be read."""
    try:
        return names_in(folder)
    except OSError:
        return []
