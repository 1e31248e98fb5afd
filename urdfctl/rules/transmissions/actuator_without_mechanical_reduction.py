"""UC212."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.transmission import Transmission, TransmissionEnd
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole, renamed
from urdfctl.rules.transmissions.common import (
    inserted,
    is_of_another_package,
    misspelt,
    on_hardware,
    read_transmissions,
)


@rule(
    "UC212",
    severity=Severity.WARNING,
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_loader.cpp: 'does not specify the required "
    "<mechanicalReduction> element.'",
    bad={
        "robot.urdf": """
            <transmission name="elbow_trans">
              <type>transmission_interface/SimpleTransmission</type>
              <joint name="elbow">
                <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
              </joint>
              «<actuator name="elbow_motor"/>»
            </transmission>
        """,
    },
    good={
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
)
def actuator_without_mechanical_reduction(project: Project) -> Iterator[Finding]:
    """An actuator has no `<mechanicalReduction>`.

    The loader of real hardware wants it in each actuator, stops at the transmission, and loads none of those behind
    it either. Gazebo's hardware simulation does not look at it.
    """
    for transmission in read_transmissions(project):
        if is_of_another_package(transmission):
            continue
        for actuator in transmission.actuators:
            if actuator.name and not actuator.reductions and is_whole(project, transmission.at):
                message = f"actuator '{actuator.name}' of {transmission.label} has no <mechanicalReduction>"
                notes = tuple(_elsewhere(transmission, actuator))
                yield Finding(actuator.at, message, notes, _fix(actuator, elsewhere=bool(notes)), on_hardware(project))


def _fix(actuator: TransmissionEnd, *, elsewhere: bool) -> Fix:
    """What is written with a slip is surely meant; what stands elsewhere is for a person to move."""
    written = misspelt(actuator.others, "mechanicalReduction")
    if written:
        edits = renamed(written, "mechanicalReduction")
        return Fix(f"write <mechanicalReduction> for <{written.name}>", edits, safe=True)
    element = "<mechanicalReduction>1</mechanicalReduction>"
    edits = () if elsewhere else inserted(actuator.at, element)
    return Fix(f"add {element} to the actuator, or the ratio of its gear", edits)


def _elsewhere(transmission: Transmission, actuator: TransmissionEnd) -> Iterator[Note]:
    written = misspelt(actuator.others, "mechanicalReduction")
    if written:
        yield Note(f"<{written.name}> is not read: the element is spelt <mechanicalReduction>", written.at)
    for joint in transmission.joints:
        for reduction in joint.reductions[:1]:
            yield Note("the one in <joint> does not stand for it: it belongs inside <actuator>", reduction.at)
    for other in transmission.others:
        if other.name == "mechanicalReduction":
            yield Note("this one stands beside the actuator; it belongs inside <actuator>", other.at)
