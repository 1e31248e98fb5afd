"""UC211."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.robot import Transmission
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole
from urdfctl.rules.transmissions.common import misspelt, read_transmissions, takes_empty_names


@rule(
    "UC211",
    runtime="drops",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="ros_control transmission_interface/src/transmission_parser.cpp: 'Failed to load actuators for "
    "transmission', 'No name attribute specified for actuator.', 'Empty name attribute specified for "
    "actuator.'",
    bad=[
        {
            "robot.urdf": """
                «<transmission name="elbow_trans">»
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
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
def transmission_without_actuator(project: Project) -> Iterator[Finding]:
    """Transmission without an actuator, or with an unnamed one.

    ros_control skips the transmission, so no controller can claim its joint. This applies in Gazebo too, which does not
    use actuators. If an actuator's name is empty, only that actuator is skipped.
    """
    for transmission in read_transmissions(project):
        if not transmission.actuators and is_whole(project, transmission.at):
            fix = Fix('add <actuator name="..."><mechanicalReduction>1</mechanicalReduction></actuator>')
            yield Finding(transmission.at, f"{transmission.label} has no <actuator>", tuple(_why(transmission)), fix)
        for actuator in transmission.actuators:
            if actuator.name is None:
                yield Finding(actuator.at, f"<actuator> of {transmission.label} has no 'name'")
            elif not actuator.name and not takes_empty_names(project):
                others = any(other.name for other in transmission.actuators)
                severity = Severity.WARNING if others else Severity.ERROR
                message = f"<actuator> of {transmission.label} has an empty 'name'"
                yield Finding(actuator.at, message, severity=severity)


def _why(transmission: Transmission) -> Iterator[Note]:
    misspelled = misspelt(transmission.others, "actuator")
    if misspelled:
        yield Note(f"<{misspelled.name}> is ignored; the element is called <actuator>", misspelled.at)
