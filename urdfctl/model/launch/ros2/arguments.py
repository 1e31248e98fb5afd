"""The arguments that launch files declare, and those that included files are given in vain."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from urdfctl.model.launch import Word
from urdfctl.names import nearest
from urdfctl.source.launch.terms import Table
from urdfctl.source.opaque import UNKNOWN


class Arguments:
    """What a launch file and its included files declare.

    own: what the file itself declares, with the defaults; None for an argument that has to be given.
    choices: the values that it allows.
    declared: the names of all declarations, in the order in which they run.
    slips: arguments for included files that these do not declare, each with the one that was probably meant.
    """

    def __init__(self) -> None:
        self.own: dict[str, str | None] = {}
        self.choices: dict[str, tuple[str, ...]] = {}
        self.declared: list[str] = []
        self.slips: list[tuple[Word, str]] = []

    def declare(self, name: str, default: str | None, choices: Sequence[str] | None, *, is_own: bool) -> None:
        """Add a declaration."""
        self.declared.append(name)
        if is_own:
            self.own.setdefault(name, default)
            if choices is not None:
                self.choices.setdefault(name, tuple(choices))

    def give(self, given: Table | None, declared: Collection[str]) -> None:
        """Compare what an included file is given with all that it and its own included files declare."""
        if given is None or any(UNKNOWN in name for name in declared):
            return
        left = [name for name in dict.fromkeys(declared) if name not in given.entries]
        for name in given.entries:
            meant = nearest(name, left) if name not in declared else None
            if meant is not None:
                self.slips.append((Word(name, given.keys[name]), meant))
