"""Helpers shared by the URDF rules: ROS version, missing attributes, duplicate names, commanded joints."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import sure_simulator
from urdfctl.model.robot import Robot, Tag
from urdfctl.names import enumerated
from urdfctl.rule import Finding, Note, Project, Severity
from urdfctl.rules.common import in_words, is_known
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

_MOST_NAMED = 3
"""A message names up to this many missing attributes and counts the rest."""


def known_part(text: str) -> str:
    """Return a text without the parts whose value is unknown."""
    return text.replace(UNKNOWN, "")


def may_be_ros2(project: Project) -> bool:
    """Return whether the robot may target ROS 2."""
    return bool(set(project.distros) & set(ROS2))


def lacking(tag: Tag, attributes: Iterable[str]) -> str:
    """Return the attributes that an element lacks, as they follow "has no" in a message; empty if it has all."""
    missing = [name for name in attributes if name not in tag.attributes]
    if len(missing) > _MOST_NAMED:
        return in_words(missing, _MOST_NAMED)
    return enumerated((f"'{name}'" for name in missing), "or")


def duplicates(kind: str, parts: Iterable[tuple[str | None, Place]]) -> Iterator[Finding]:
    """Yield a finding for each part whose name an earlier part has."""
    first: dict[str, Place] = {}
    for name, at in parts:
        if name is None or not is_known(name):
            continue
        before = first.setdefault(name, at)
        if before is not at:
            note = Note("first defined here", before["name"])
            yield Finding(at["name"], f"{kind} '{name}' is already defined; rename or remove one", (note,))


def severity_in_gazebo(project: Project, *, refused_by: Collection[str] = ()) -> Severity:
    """Return the severity of what only Gazebo does not accept.

    An error if the robot certainly runs in a simulator in `refused_by`; a warning if Gazebo may run the robot, which has elements or
    plugins for it; info if nothing shows that.
    """
    if sure_simulator(project) in refused_by:
        return Severity.ERROR
    robot = project.robot
    is_for_gazebo = project.simulator in ("gz", "gazebo-classic") or (robot is not None and bool(robot.gazebos))
    return Severity.WARNING if is_for_gazebo else Severity.INFO


def commanded_joints(robot: Robot) -> set[str]:
    """Return the names of the joints with a ROS 1 transmission or a ROS 2 command interface."""
    names = {joint.name for transmission in robot.transmissions for joint in transmission.joints}
    for component in robot.ros2_controls:
        names |= {part.name for part in component.parts if part.kind == "joint" and part.commands}
    return {name for name in names if name}
