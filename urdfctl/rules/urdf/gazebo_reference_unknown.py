"""UC156."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, whole_robot_in
from urdfctl.rules.written import at_written

_COMMENT = rb"(?s)<!--.*?-->"


@rule(
    "UC156",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="sdformat src/parser_urdf.cc InsertSDFExtensionLink(), InsertSDFExtensionJoint(): looked up by link and joint",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <gazebo reference="«fore_link»"><mu1>0.9</mu1></gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo reference="fore"><mu1>0.9</mu1></gazebo>
            """,
        },
    ],
)
def gazebo_reference_unknown(project: Project) -> Iterator[Finding]:
    """<gazebo> refers to an unknown link or joint.

    Gazebo silently drops the element's content: the sensor, the friction or the colour is missing. If several robots
    include the file and another one has the link or joint, or a condition leaves it out, this is only worth knowing.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    taken = {gazebo.reference for gazebo in robot.gazebos}
    names = KnownNames([*(link.name for link in robot.links), *robot.joint_names], taken)
    for gazebo in robot.gazebos:
        reference = gazebo.reference
        if not reference or reference in names or not is_known(reference):
            continue
        meant = names.meant_by(reference)
        hint = f"; did you mean '{meant}'?" if meant else ""
        message = f"<gazebo> refers to '{reference}', which is not a link or joint of the robot{hint}"
        at = gazebo.at["reference"]
        if _is_left_out(robot, at.span.text):
            message = f"<gazebo> refers to '{reference}', which the robot has only with other arguments"
            yield Finding(at, message, severity=Severity.INFO)
        else:
            yield at_written(at, reference, meant, message, safe=names.is_sure(reference, meant))


def _is_left_out(robot: Robot, name: str) -> bool:
    """Whether the xacro files of the robot define a link or joint of this name, but a condition leaves it out."""
    places = [*(link.at for link in robot.links), *(joint.at for joint in robot.joints)]
    if any(place["name"].span.text == name for place in places):
        return False
    sources = {id(place.source): place.source for place in places}
    written = rf"<(?:link|joint(?=\s[^<>]*\btype\s*=))\s[^<>]*?\bname\s*=\s*[\"']{re.escape(name)}[\"']".encode()
    return any(
        source.is_xacro and re.search(written, re.sub(_COMMENT, b"", source.data)) for source in sources.values()
    )
