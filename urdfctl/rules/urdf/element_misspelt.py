"""UC154."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.parts import Tag
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import respelt, robot_in
from urdfctl.rules.urdf.grammar import ELEMENTS, read_tags

OF_OTHERS = frozenset(
    {"sensor", "self_collision_checking", "contact", "contact_coefficients", "linkage", "joints", "links"}
)
"""Elements that other URDF readers use, and elements that resemble a URDF element only in spelling."""


@rule(
    "UC154",
    severity=Severity.WARNING,
    runtime="ignores",
    authority='urdfdom urdf_parser: FirstChildElement("...") by exact name; unknown elements are silently ignored',
    bad={
        "robot.urdf": """
            <link name="tool">
              <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
              «<colision>»<geometry><sphere radius="0.1"/></geometry></colision>
            </link>
            <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
        """,
    },
    good={
        "robot.urdf": """
            <link name="tool">
              <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
              <collision><geometry><sphere radius="0.1"/></geometry></collision>
              <contact><friction_anchor/></contact>
            </link>
            <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
        """,
    },
)
def element_misspelt(project: Project) -> Iterator[Finding]:
    """Misspelt element.

    urdfdom silently ignores unknown elements, so the part is missing. If the only `<ros2_control>` is misspelt, ROS 2's
    controller manager rejects the description.
    """
    robot = robot_in(project)
    if robot is None:
        return
    for tag in robot.others:
        for meant in _meant(tag, "robot"):
            lost = meant == "ros2_control" and not robot.ros2_controls and set(project.distros) <= set(ROS2)
            severity = Severity.ERROR if lost else Severity.WARNING
            message = f"<{tag.name}> of the robot is ignored; did you mean <{meant}>?"
            yield Finding(tag.at, message, fix=respelt(tag, meant), severity=severity)
    for tag, children, owner in read_tags(robot):
        for child in children if tag.name != "geometry" else ():
            for meant in _meant(child, tag.name):
                message = f"<{child.name}> of {owner} is ignored; did you mean <{meant}>?"
                yield Finding(child.at, message, fix=respelt(child, meant))


def _meant(tag: Tag, parent: str) -> tuple[str, ...]:
    """The element that an unknown one most likely misspells; empty if it may be intended."""
    known = ELEMENTS[parent]
    if tag.name in known or tag.name in OF_OTHERS or ":" in tag.name:
        return ()
    meant = nearest(tag.name, known)
    return (meant,) if meant else ()
