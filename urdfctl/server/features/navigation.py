"""Where a name is defined and used, and how to rename it everywhere."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable

from urdfctl.diagnostic import Location, ShownEdit, located
from urdfctl.errors import UserError
from urdfctl.server.analysis.names import LINK, NamePlace, name_at, names_in
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.scopes import macro_around
from urdfctl.server.analysis.templates import renamed_parts
from urdfctl.server.analysis.xacro_names import MACRO, PARAMETER, PROPERTY

_IDENTIFIER = r"[A-Za-z_]\w*"
_SPECIAL = {(LINK, "world")}
_OF_XACRO = {MACRO, PARAMETER, PROPERTY}
_SIGNS = set("\"'<>&${}") | set(" \t\n")


class NamesAround:
    """The names in all robots of a question, and the one at its place; None if there is none."""

    def __init__(self, question: Question) -> None:
        self.at: NamePlace | None = None
        self.is_current = question.is_current
        found: dict[tuple[str, int, int, str], NamePlace] = {}
        for robot in question.robots:
            names = names_in(robot)
            if self.at is None:
                self.at = name_at(names, question.file, question.offset)
            for name in names:
                found.setdefault((name.span.file, name.span.start, name.span.end, name.text), name)
        self.all = list(found.values())

    def same(self) -> list[NamePlace]:
        """Return all places of the thing that is named there."""
        if self.at is None:
            return []
        at = self.at
        if not at.is_computed:
            return [name for name in self.all if name.is_same(at)]
        here = [name for name in self.all if name.span == at.span]
        return [name for name in self.all if any(name.is_same(one) for one in here)]


def definitions(around: NamesAround) -> list[Location]:
    """Return where the thing at the asked place is defined; a property first of all in the same macro."""
    defined = [name for name in around.same() if name.defines]
    if around.at is not None and around.at.kind == PROPERTY:
        here = _macro_of(around.at)
        defined = [name for name in defined if _macro_of(name) == here] or defined
    return _places(defined)


def _macro_of(name: NamePlace) -> tuple[str, str]:
    """The file and the macro that a name is written in; the file is empty outside of macros."""
    macro = macro_around(name.span.source.data, name.span.start)
    return name.span.file if macro else "", macro


def references(around: NamesAround, *, with_definition: bool) -> list[Location]:
    """Return where the thing at the asked place is used."""
    return _places(name for name in around.same() if with_definition or not name.defines)


def _places(names: Iterable[NamePlace]) -> list[Location]:
    return sorted({located(name.span) for name in names})


def check_renamable(around: NamesAround) -> None:
    """Raise UserError with the reason if the thing at the asked place cannot have another name, whatever it is."""
    at = around.at
    if at is None or at.is_computed:
        return
    places = around.same()
    computed = next((name for name in places if name.is_computed), None)
    if computed is not None:
        raise _of_computed(computed)
    if (at.kind, at.text) in _SPECIAL:
        raise UserError(f"{at.kind} '{at.text}' has a meaning of its own by this name")
    if not any(name.defines for name in places):
        raise UserError(f"{at.kind} '{at.text}' is not defined in these files")


def _of_computed(name: NamePlace) -> UserError:
    where = located(name.span)
    written = f"'{name.span.text}' at {os.path.basename(where.file)}:{where.line}"
    return UserError(f"'{name.text}' is computed from {written}; rename its literal parts there")


def renamed(around: NamesAround, new: str) -> list[ShownEdit]:
    """Return the edits that rename the thing at the asked place. UserError with the reason if that is impossible.

    A computed name is given with its expressions: `${prefix}wrist` for `${prefix}elbow`.
    """
    at = around.at
    if at is None or not around.is_current:
        raise UserError("there is no name here that can be renamed, or a file with it cannot be read now")
    if at.is_computed and "$" in new and not _SIGNS - set("${}") & set(new):
        return renamed_parts(around.all, at, new)
    check_renamable(around)
    if at.is_computed:
        raise _of_computed(at)
    if (at.kind in _OF_XACRO and not re.fullmatch(_IDENTIFIER, new)) or not new or _SIGNS & set(new):
        raise UserError(f"'{new}' is no name for a {at.kind}")
    if any(name.kind == at.kind and name.text == new and name.scope == at.scope for name in around.all):
        raise UserError(f"{at.kind} '{new}' exists already")
    shared = {PROPERTY: PARAMETER, PARAMETER: PROPERTY}.get(at.kind)
    if any(name.kind == shared and name.text in {at.text, new} for name in around.all):
        raise UserError(f"'{at.text}' or '{new}' is a parameter of a macro and elsewhere a property; rename it by hand")
    return [ShownEdit(location, new) for location in _places(around.same())]
