"""UC168."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.degrees import is_rotation_in_degrees, rotation_in_words, written_in_radians
from urdfctl.model.robot import Robot, Tag
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.written import at_value

_WRIST = """
    <link name="tool">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
      <visual>%s<geometry><box size="0.1 0.1 0.1"/></geometry></visual>
    </link>
    <joint name="wrist" type="fixed">
      <parent link="fore"/><child link="tool"/>%s
    </joint>
"""


@rule(
    "UC168",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="REP 103: angles are in radians; urdf: <origin> rpy is in radians",
    bad=[
        {"robot.urdf": _WRIST % ("", '<origin xyz="0 0 1" rpy="«-90 0 0»"/>')},
        {"robot.urdf": _WRIST % ('<origin rpy="«0 0 45»"/>', "")},
    ],
    good=[
        {"robot.urdf": _WRIST % ('<origin rpy="0 0 0.785"/>', '<origin xyz="0 0 1" rpy="-1.5708 0 0"/>')},
        {"robot.urdf": _WRIST % ("", '<origin xyz="0 0 1" rpy="0 7.854 0"/>')},
    ],
)
def rotation_in_degrees(project: Project) -> Iterator[Finding]:
    """Rotation that is most likely in degrees.

    The part is turned several times around, and points into a direction that nobody meant. The smoke test finds the same
    as UC980.
    """
    robot = robot_in(project)
    for what, tag in _parts(robot) if robot else ():
        origin = next(tag.named("origin"), None)
        given = origin.attributes.get("rpy", "").split() if origin else []
        angles = [_number(text) for text in given]
        if origin is None or not is_rotation_in_degrees(angles):
            continue
        message = rotation_in_words(what, angles)
        yield at_value(project, origin.at["rpy"], message, fix=_in_radians(project, origin, given))


def _parts(robot: Robot) -> Iterator[tuple[str, Tag]]:
    """Yield the parts of a robot that can have a rotation, each with its label."""
    yield from ((f"joint '{joint.name}'", joint.tag) for joint in robot.joints)
    for link in robot.links:
        for part in ("inertial", "visual", "collision"):
            yield from ((f"<{part}> of link '{link.name}'", tag) for tag in link.tag.named(part))


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return 0.0


def _in_radians(project: Project, origin: Tag, given: list[str]) -> Fix | None:
    """Write a rotation in rad where it is written as numbers; nothing where it is calculated."""
    at = project.origin(origin.at["rpy"])
    if at.span.text.split() != given:
        return None
    texts = [written_in_radians(text, in_xacro=at.source.is_xacro) if _number(text) else "0" for text in given]
    return Fix(f"write '{' '.join(texts)}'", (Edit(at.span, " ".join(texts)),))
