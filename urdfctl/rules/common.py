"""What the rules of several families share: who refuses what, texts that are not known, names that were meant."""

from __future__ import annotations

import re
from collections.abc import Iterable

from urdfctl.model.parts import Tag
from urdfctl.model.robot import Robot
from urdfctl.rule import Edit, Fix, Project, Severity
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place, SourceSpan
from urdfctl.suggest import enumerated, nearest

_MOST_COMPARED = 20
_CUT_OUT = rb"<xacro:(?!if\b|unless\b|property\b|arg\b)"
_CONDITION = rb"<xacro:(if|unless)\b"


def robot_in(project: Project) -> Robot | None:
    """The robot, where the root element is one."""
    robot = project.robot
    return robot if robot is not None and robot.element == "robot" else None


def whole_robot_in(project: Project) -> Robot | None:
    """The robot, where the file means to describe a whole one: not a part that other xacro files include."""
    robot = robot_in(project)
    return None if robot is None or is_fragment(robot) else robot


def is_xacro(robot: Robot) -> bool:
    """Whether the description went through xacro."""
    return robot.at.source.is_xacro


def is_fragment(robot: Robot) -> bool:
    """Whether a xacro file is rather a part of a robot: it has fewer than two links, or hangs on a link of the whole."""
    if not is_xacro(robot):
        return False
    if len(robot.links) < 2:  # noqa: PLR2004
        return True
    links = {link.name for link in robot.links}
    outward = any(joint.parent and joint.parent.name not in links for joint in robot.joints)
    rootless = links <= {joint.child.name for joint in robot.joints if joint.child}
    return outward and (rootless or robot.name is None)


def is_known(*texts: str | None) -> bool:
    """Whether all of some texts could be worked out: of others nothing may be claimed."""
    return not any(text and UNKNOWN in text for text in texts)


def is_whole(project: Project, at: Place) -> bool:
    """Whether what an element lacks is truly absent: nothing was cut out of it when expansion failed somewhere, and no
    macro of another file is called in it."""
    if at.closing is None or (project.complete and not project.library):
        return True
    return not re.search(_CUT_OUT if project.library else b"<xacro:", at.source.data[at.start : at.closing])


def severity_where(project: Project, refusing: Iterable[str]) -> Severity:
    """An error where every distro that the project may be for refuses the part, else a warning."""
    return Severity.ERROR if set(project.distros) <= set(refusing) else Severity.WARNING


def label(kind: str, name: str | None) -> str:
    """What a message calls a part: `joint 'elbow'`, or `a joint without name`."""
    return f"{kind} '{name}'" if name else f"a {kind} without name"


def is_all_there(project: Project, tag: Tag) -> bool:
    """Whether what is not seen in an element is truly not there: all that stands in it could be worked out."""
    return is_whole(project, tag.at) and not any(child.name == UNKNOWN for child in tag.children)


class Names:
    """The names that a reference may mean. Only the first slips are compared with each of them: that takes long."""

    def __init__(self, names: Iterable[str | None]) -> None:
        self._names = {name for name in names if name}
        self._stripped = {name.strip(): name for name in self._names}
        self._left = _MOST_COMPARED
        self._meant: dict[str, str | None] = {}

    def __contains__(self, name: str) -> bool:
        return name in self._names

    def meant_by(self, name: str) -> str | None:
        """The name that differs from this one in blanks around it, or is the most like it; None where none is."""
        found = self._stripped.get(name.strip())
        if found is None and name not in self._meant and self._left:
            self._left -= 1
            self._meant[name] = nearest(name, self._names)
        return found or self._meant.get(name)


def is_conditional(at: Place) -> bool:
    """Whether conditions decide on what stands in an element, so that other arguments make another one of it."""
    return at.closing is not None and bool(re.search(_CONDITION, at.source.data[at.start : at.closing]))


def replaced(at: Place, old: str, new: str, *, safe: bool = False, title: str | None = None) -> Fix:
    """The repair that writes `new` for `old`; for a person to make where the source does not say `old` literally."""
    edits = (Edit(at.span, new),) if at.span.text.replace("\r\n", "\n") == old else ()
    return Fix(title or f"write '{new}'", edits, safe and bool(edits))


def renamed(tag: Tag, name: str) -> tuple[Edit, ...]:
    """The edits that give an element another name."""
    length = len(tag.name.encode())
    return tuple(
        Edit(SourceSpan(tag.at.source, start + len(mark), start + len(mark) + length), name)
        for start, mark in marks(tag.at)
    )


def respelt(tag: Tag, meant: str | None) -> Fix | None:
    """The repair that gives an element the name that was meant; surely so where only the letters' case differs."""
    return Fix(f"write <{meant}>", renamed(tag, meant), safe=meant == tag.name.lower()) if meant else None


def attribute_respelt(tag: Tag, name: str, meant: str | None) -> Fix | None:
    """The repair that gives an attribute the name that was meant; surely so where only the letters' case differs."""
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
    """Where the start tag of an element begins, and its end tag if it has one, and what they begin with."""
    tag = at.source.start_tag(at.start)
    ends = [(at.closing, "</")] if at.closing is not None and tag is not None and not tag.self_closed else []
    return [(at.start, "<"), *ends]


def in_words(names: Iterable[str], most: int = 5) -> str:
    """Some names, quoted; the first few of many."""
    quoted = [f"'{name}'" for name in names]
    if len(quoted) > most:
        quoted[most:] = [f"{len(quoted) - most} more"]
    return enumerated(quoted)
