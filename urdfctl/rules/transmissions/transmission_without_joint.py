"""UC219."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.robot import Transmission
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole
from urdfctl.rules.transmissions.common import misspelt, read_transmissions, takes_empty_names


@rule(
    "UC219",
    runtime="drops",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="ros_control transmission_interface/src/transmission_parser.cpp: 'Failed to load joints for "
    "transmission', 'No name attribute specified for joint.', 'Empty name attribute specified for joint.'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  «<joint>»
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
)
def transmission_without_joint(project: Project) -> Iterator[Finding]:
    """Transmission without a joint, or with an unnamed one.

    ros_control skips the transmission, so no controller can claim what it drives. If a joint's name is empty, only that
    joint is skipped.
    """
    for transmission in read_transmissions(project):
        if not transmission.joints and is_whole(project, transmission.at):
            yield Finding(transmission.at, f"{transmission.label} has no <joint>", tuple(_why(transmission)))
        for joint in transmission.joints:
            if joint.name is None:
                message = f"<joint> of {transmission.label} has no 'name'; add the name of a joint of the robot"
                yield Finding(joint.at, message)
            elif not joint.name and not takes_empty_names(project):
                severity = Severity.WARNING if transmission.kept_joints else Severity.ERROR
                yield Finding(joint.at, f"<joint> of {transmission.label} has an empty 'name'", severity=severity)


def _why(transmission: Transmission) -> Iterator[Note]:
    misspelled = misspelt(transmission.others, "joint")
    if misspelled:
        yield Note(f"<{misspelled.name}> is ignored; the element is called <joint>", misspelled.at)
