"""What the rules on the URDF itself share: who refuses what, texts that are not known, repairs of one attribute."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.parts import Tag
from urdfctl.model.robot import Robot
from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place
from urdfctl.suggest import nearest

_MOST_COMPARED = 20


def is_known(*texts: str | None) -> bool:
    """Whether all of some texts could be worked out."""
    return not any(text and UNKNOWN in text for text in texts)


def known_part(text: str) -> str:
    """What is known of a text of which some could not be worked out."""
    return text.replace(UNKNOWN, "")


def severity_where(project: Project, refusing: Iterable[str]) -> Severity:
    """An error where every distro that the project may be for refuses the part, else a warning."""
    return Severity.ERROR if set(project.distros) <= set(refusing) else Severity.WARNING


def may_be_ros2(project: Project) -> bool:
    """Whether the robot may be meant for ROS 2."""
    return bool(set(project.distros) & set(ROS2))


def robot_in(project: Project) -> Robot | None:
    """The robot, where the root element is one."""
    robot = project.robot
    return robot if robot is not None and robot.element == "robot" else None


def whole_robot_in(project: Project) -> Robot | None:
    """The robot, where the file means to describe a whole one: not a part that other xacro files include."""
    robot = robot_in(project)
    return None if robot is None or is_fragment(robot) else robot


def is_xacro(robot: Robot) -> bool:
    """Whether the description went through xacro: by its file's name, or because it declares xacro's namespace."""
    source = robot.at.source
    return source.path.endswith(".xacro") or b"xmlns:xacro" in source.data[:4096]


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


class Names:
    """The names that a reference may mean. Only the first slips are compared with each of them: that takes long."""

    def __init__(self, names: Iterable[str | None]) -> None:
        self._names = {name for name in names if name}
        self._stripped = {name.strip(): name for name in self._names}
        self._left = _MOST_COMPARED

    def __contains__(self, name: str) -> bool:
        return name in self._names

    def meant_by(self, name: str) -> str | None:
        """The name that differs from this one in blanks around it, or is the most like it; None where none is."""
        found = self._stripped.get(name.strip())
        if found is None and self._left:
            self._left -= 1
            found = nearest(name, self._names)
        return found


def replaced(at: Place, old: str, new: str, *, safe: bool = False, title: str | None = None) -> Fix:
    """The repair that writes `new` for `old`; for a person to make where the source does not say `old` literally."""
    edits = (Edit(at.span, new),) if at.span.text == old else ()
    return Fix(title or f"write '{new}'", edits, safe and bool(edits))


def label(kind: str, name: str | None) -> str:
    """What a message calls a part: `joint 'elbow'`, or `a joint without name`."""
    return f"{kind} '{name}'" if name else f"a {kind} without name"


def in_words(names: Iterable[str], most: int = 5) -> str:
    """Some names, quoted; the first few of many."""
    quoted = [f"'{name}'" for name in names]
    if len(quoted) > most:
        quoted[most:] = [f"{len(quoted) - most} more"]
    return " and ".join(part for part in (", ".join(quoted[:-1]), quoted[-1]) if part)


def lacking(tag: Tag, attributes: Iterable[str]) -> str:
    """The attributes that an element lacks, in words; empty where it has all."""
    missing = [f"'{name}'" for name in attributes if name not in tag.attributes]
    return " and no ".join(missing)


def duplicates(kind: str, parts: Iterable[tuple[str | None, Place]]) -> Iterator[Finding]:
    """One finding for each part whose name an earlier one has."""
    first: dict[str, Place] = {}
    for name, at in parts:
        if name is None or not is_known(name):
            continue
        before = first.setdefault(name, at)
        if before is not at:
            yield Finding(at["name"], f"there is already a {kind} '{name}'", (Note("it is here", before["name"]),))


def commanded_joints(robot: Robot) -> set[str]:
    """The joints that a transmission of ROS 1 or a command interface of ROS 2 drives."""
    names = {joint.name for transmission in robot.transmissions for joint in transmission.joints}
    for component in robot.ros2_controls:
        names |= {part.name for part in component.parts if part.kind == "joint" and part.commands}
    return {name for name in names if name}
