"""What the rules on the URDF itself share: whose robot it is, what parts are called, which are there twice."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.parts import Tag
from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Note, Project
from urdfctl.rules.common import is_known
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place


def known_part(text: str) -> str:
    """What is known of a text of which some could not be worked out."""
    return text.replace(UNKNOWN, "")


def may_be_ros2(project: Project) -> bool:
    """Whether the robot may be meant for ROS 2."""
    return bool(set(project.distros) & set(ROS2))


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
