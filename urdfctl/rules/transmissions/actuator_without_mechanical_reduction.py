"""UC212."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.robot import Transmission, TransmissionEnd
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole, renamed
from urdfctl.rules.insertions import inserted
from urdfctl.rules.transmissions.common import (
    is_of_another_package,
    misspelt,
    on_hardware,
    read_transmissions,
)


@rule(
    "UC212",
    runtime="refuses",
    because="only the loader of real hardware does",
    severity=Severity.WARNING,
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_loader.cpp: 'does not specify the required "
    "<mechanicalReduction> element.'",
    bad=[
        {
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
def actuator_without_mechanical_reduction(project: Project) -> Iterator[Finding]:
    """Actuator without `<mechanicalReduction>`.

    The transmission loader of real hardware requires it in each actuator. It stops at this transmission, and does not
    load the later ones either. Gazebo's hardware simulation ignores it.
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
    """A misspelt element is safe to rename; one in the wrong place must be moved by hand."""
    misspelled = misspelt(actuator.others, "mechanicalReduction")
    if misspelled:
        edits = renamed(misspelled, "mechanicalReduction")
        return Fix(f"rename <{misspelled.name}> to <mechanicalReduction>", edits, safe=True)
    element = "<mechanicalReduction>1</mechanicalReduction>"
    edits = () if elsewhere else inserted(actuator.at, element)
    return Fix(f"add {element} to the actuator; if it has a gear, use its ratio instead of 1", edits)


def _elsewhere(transmission: Transmission, actuator: TransmissionEnd) -> Iterator[Note]:
    misspelled = misspelt(actuator.others, "mechanicalReduction")
    if misspelled:
        yield Note(f"<{misspelled.name}> is ignored; the element is called <mechanicalReduction>", misspelled.at)
    for joint in transmission.joints:
        for reduction in joint.reductions[:1]:
            yield Note("the one in <joint> does not apply to the actuator; it belongs inside <actuator>", reduction.at)
    for other in transmission.others:
        if other.name == "mechanicalReduction":
            yield Note("this one is outside the actuator; move it into <actuator>", other.at)
