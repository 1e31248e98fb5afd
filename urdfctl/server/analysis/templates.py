"""Names that are computed, such as `${prefix}elbow`: their literal parts renamed, in all names that come of them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence

from urdfctl.diagnostic import ShownEdit, located
from urdfctl.errors import UserError
from urdfctl.server.analysis.names import NamePlace

_EXPRESSION = r"(\$\{[^{}]*\}|\$\([^()]*\))"


def renamed_parts(all_names: Sequence[NamePlace], at: NamePlace, new: str) -> list[ShownEdit]:
    """Return the edits that write a computed name in another way, and rename everything that is named by it.

    all_names: the places of names in all robots. at: the computed name. new: its new text, with the same expressions.
    Raises UserError with the reason if that is impossible.
    """
    written = at.span.text
    if _expressions(new) != _expressions(written):
        raise UserError(
            f"'{at.text}' is computed from '{written}'; change only its literal parts, as in '{_hint(written)}'"
        )
    changed: dict[str, str] = {}
    places: list[NamePlace] = []
    found = {name.text for name in all_names if (name.kind, name.span) == (at.kind, at.span)}
    while found - set(changed):
        changed.update({old: _filled(written, new, old) for old in found - set(changed)})
        places = [name for name in all_names if name.kind == at.kind and name.text in changed]
        spans = {name.span for name in places if name.span.text == written}
        found |= {name.text for name in all_names if name.kind == at.kind and name.span in spans}
    _check(all_names, places, changed, written)
    edits = {ShownEdit(located(one.span), new if one.span.text == written else changed[one.text]) for one in places}
    return sorted(edits, key=lambda edit: (edit.file, edit.start))


def _check(
    all_names: Iterable[NamePlace], places: Iterable[NamePlace], changed: Mapping[str, str], written: str
) -> None:
    """Raise UserError if a place is computed in another way, or if a new name exists already."""
    for one in places:
        if one.is_computed and one.span.text != written:
            where = located(one.span)
            there = f"'{one.span.text}' at {os.path.basename(where.file)}:{where.line}"
            raise UserError(f"'{one.text}' is also computed from {there}")
    taken = {name.text for name in all_names if any(name.kind == one.kind for one in places)}
    for name in changed.values():
        if name in taken - set(changed):
            raise UserError(f"'{name}' exists already")
    if len(set(changed.values())) < len(changed):
        raise UserError("two names would become one")


def _expressions(text: str) -> list[str]:
    return re.findall(_EXPRESSION, text)


def _hint(written: str) -> str:
    return "".join(part if index % 2 else f"new{part}" if part else "" for index, part in enumerate(_parts(written)))


def _parts(text: str) -> list[str]:
    """The literal parts of a text and, between them, its expressions."""
    return re.split(_EXPRESSION, text)


def _filled(written: str, new: str, old: str) -> str:
    """The new text with the values that the expressions have in an old name."""
    literals = _parts(written)[::2]
    found = {
        match.groups()
        for some in ("(.*)", "(.*?)")
        if (match := re.fullmatch(some.join(map(re.escape, literals)), old, re.DOTALL))
    }
    if len(found) != 1:
        raise UserError(f"which part of '{old}' comes from which expression of '{written}' is not certain")
    [values] = found
    after = _parts(new)[::2]
    return "".join(literal + value for literal, value in zip(after, (*values, ""), strict=True))
