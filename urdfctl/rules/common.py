"""Helpers for the rules of several families: severities, unknown values, misspelt names and common fixes."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable
from typing import TYPE_CHECKING

from urdfctl.control.robots import is_all_there, is_fragment, is_whole, is_xacro, robot_in, whole_robot_in
from urdfctl.model.robot import Tag
from urdfctl.names import differ_by_kind, enumerated, fuller, is_only_slip, nearest
from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity
from urdfctl.source.opaque import is_known
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.startup.per_object import once_per_object
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.model.launch import Launch

_MOST_COMPARED = 20
_CONDITION = rb"<xacro:(if|unless)\b"


def fetched_apart(project: Project, package: str, finding: Finding) -> Finding:
    """Return a finding on a package that is not here: only info if the workspace says how to get the package.

    That is a list of repositories, a README or a script that clones a repository of this name or installs its Debian
    package.
    """
    name = re.escape(package).replace("_", "[-_]")
    if not project.mentioned(rf"(?:\bclone\b|://|\bapt(?:-get)? install\b)[^\n]*\b{name}\b", of_builds=True):
        return finding
    note = Note("a README, a script or a list of repositories says how to get it")
    return finding._replace(severity=Severity.INFO, notes=(*finding.notes, note))


def severity_where(project: Project, refusing: Iterable[str]) -> Severity:
    """Return ERROR if every possible distro of the project is in `refusing`, else WARNING."""
    return Severity.ERROR if set(project.distros) <= set(refusing) else Severity.WARNING


def label(kind: str, name: str | None) -> str:
    """Return a part's name in messages: `joint 'elbow'`, or `a joint without name`."""
    return f"{kind} '{name}'" if name else f"a {kind} without name"


class KnownNames:
    """The names that a reference can use. Only the first unknown names are compared with all of them, which is slow.

    taken: names that other references use, so that none of them is meant where another name is unknown.
    """

    def __init__(self, names: Iterable[str | None], taken: Iterable[str | None] = ()) -> None:
        self._names = {name for name in names if name}
        self._free = self._names.difference(taken)
        self._stripped = {name.strip(): name for name in self._free}
        self._left = _MOST_COMPARED
        self._meant: dict[str, str | None] = {}

    def __contains__(self, name: str) -> bool:
        return name in self._names

    def meant_by(self, name: str) -> str | None:
        """Return the known name that differs only in surrounding blanks, or is most similar. None if there is none."""
        stripped = self._stripped.get(name.strip())
        if stripped is None and name not in self._meant and self._left:
            self._left -= 1
            self._meant[name] = nearest(name, self._free) or _with_other_words(name, self._free)
        return stripped or self._meant.get(name)

    def is_sure(self, name: str, meant: str | None) -> bool:
        """Return whether a name is another one with one letter wrong, and no other name comes near."""
        return meant is not None and is_only_slip(name, meant, self._names)

    def fix(self, place: Place, name: str, meant: str | None) -> Fix | None:
        """Return the fix that writes the name that is meant: safe if one letter is wrong, and no other name comes near."""
        return replaced(place, name, meant, safe=self.is_sure(name, meant)) if meant else None


def _with_other_words(name: str, known: Iterable[str]) -> str | None:
    """The only known name that has all words of another one in their order and more, or fewer, or differs by the word
    for what it names; None if there is none."""
    names = list(known)
    found = {other for other in names if fuller(name, [other]) or fuller(other, [name]) or differ_by_kind(name, other)}
    return found.pop() if len(found) == 1 else None


def is_conditional(at: Place) -> bool:
    """Return whether an element contains xacro conditions, so that its content depends on the arguments."""
    if at.closing is None:
        return False
    conditions = _conditions(at.source)
    first = bisect_left(conditions, at.start)
    return first < len(conditions) and conditions[first] < at.closing


@once_per_object
def _conditions(source: SourceText) -> list[int]:
    """The byte offsets of the xacro conditions in a file."""
    return [found.start() for found in re.finditer(_CONDITION, source.data)]


def replaced(at: Place, old: str, new: str, *, safe: bool = False, title: str | None = None) -> Fix:
    """Return the fix that replaces `old` by `new`. It has no edits if the source does not contain `old` literally."""
    edits = (Edit(at.span, new),) if at.span.text.replace("\r\n", "\n") == old else ()
    return Fix(title or f"write '{new}'", edits, safe and bool(edits))


def renamed(tag: Tag, name: str) -> tuple[Edit, ...]:
    """Return the edits that rename an element."""
    length = len(tag.name.encode())
    return tuple(
        Edit(SourceSpan(tag.at.source, start + len(mark), start + len(mark) + length), name)
        for start, mark in marks(tag.at)
    )


def respelt(tag: Tag, meant: str | None) -> Fix | None:
    """Return the fix that renames an element. It is safe if only upper and lower case differ."""
    return Fix(f"write <{meant}>", renamed(tag, meant), safe=meant == tag.name.lower()) if meant else None


def attribute_respelt(tag: Tag, name: str, meant: str | None) -> Fix | None:
    """Return the fix that renames an attribute. It is safe if only upper and lower case differ."""
    if meant is None:
        return None
    source = tag.at.source
    written = re.search(re.escape(name.encode()) + rb"\s*=\s*[\"']\Z", source.data[tag.at.start : tag.at[name].start])
    edits: tuple[Edit, ...] = ()
    if written:
        start = tag.at.start + written.start()
        edits = (Edit(SourceSpan(source, start, start + len(name.encode())), meant),)
    return Fix(f"write {meant}", edits, safe=bool(edits) and meant == name.lower())


def marks(at: Place) -> list[tuple[int, str]]:
    """Return the offsets of an element's start tag and end tag (if any), each with its first characters: < or </."""
    tag = at.source.start_tag(at.start)
    ends = [(at.closing, "</")] if at.closing is not None and tag is not None and not tag.self_closed else []
    return [(at.start, "<"), *ends]


def in_words(names: Iterable[str], most: int = 5) -> str:
    """Return names in quotes, as `'a', 'b' and 'c'`. Only the first `most`, then `and 4 more`."""
    quoted = [f"'{name}'" for name in names]
    if len(quoted) > most:
        quoted[most:] = [f"{len(quoted) - most} more"]
    return enumerated(quoted)


class Doubt(NamedTuple):
    """How sure it is what a launch file starts: a severity instead of that of the rule, and notes."""

    severity: Severity | None = None
    notes: tuple[Note, ...] = ()


def doubt_of(launch: Launch) -> Doubt | None:
    """Return how sure it is what a launch file starts: less if an included file is not here; None if it is unknown."""
    if launch.complete:
        return Doubt()
    if not launch.unread:
        return None
    notes = (Note("this file cannot be read here; it may start what is missing", word.at) for word in launch.unread[:3])
    return Doubt(Severity.WARNING, tuple(notes))


__all__ = [
    "Doubt",
    "KnownNames",
    "attribute_respelt",
    "doubt_of",
    "in_words",
    "is_all_there",
    "is_conditional",
    "is_fragment",
    "is_known",
    "is_whole",
    "is_xacro",
    "label",
    "marks",
    "renamed",
    "replaced",
    "respelt",
    "robot_in",
    "severity_where",
    "whole_robot_in",
]
