"""UC156."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, whole_robot_in
from urdfctl.rules.written import at_written


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
    include the file and another one has the link or joint, this is only worth knowing.
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
        yield at_written(gazebo.at["reference"], reference, meant, message, safe=names.is_sure(reference, meant))
