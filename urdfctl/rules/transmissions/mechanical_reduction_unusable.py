"""UC225."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.robot import ElementText, Transmission, TransmissionEnd, leading_number
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.common import is_of_another_package, on_hardware, read_transmissions
from urdfctl.rules.transmissions.facts import TYPES

_PLAIN = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


@rule(
    "UC225",
    runtime="refuses",
    because="only the loader of real hardware does",
    severity=Severity.WARNING,
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_loader.cpp: 'specifies the <mechanicalReduction> "
    "element, but is not a number.'; simple_transmission.h: 'Transmission reduction ratio cannot be "
    "zero.'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    <mechanicalReduction>«0»</mechanicalReduction>
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
                    <mechanicalReduction>-50.5</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
)
def mechanical_reduction_unusable(project: Project) -> Iterator[Finding]:
    """`<mechanicalReduction>` is empty, zero or not a number.

    The loader of real hardware stops there, and loads neither this transmission nor the later ones. It reads the number
    at the start of the text and ignores the rest: `1,5` is 1. Gazebo's hardware simulation ignores the element.
    """
    for transmission in read_transmissions(project):
        if is_of_another_package(transmission):
            continue
        for kind, end in _read_ends(transmission):
            for reduction in end.reductions[:1]:
                fault = _fault(reduction)
                if fault and is_known(reduction.value):
                    message = f"<mechanicalReduction> of {kind} '{end.name}' of {transmission.label} {fault}"
                    fix = Fix("write the gear ratio as a number, or 1 without a gear")
                    is_rejected = not fault.startswith("is read")
                    severity = on_hardware(project) if is_rejected else None
                    yield Finding(reduction.at.content, message, fix=fix, severity=severity)


def _read_ends(transmission: Transmission) -> list[tuple[str, TransmissionEnd]]:
    """The ends whose reduction is read. Only types with two joints read the reduction of a joint."""
    kind = TYPES.get(transmission.type.value) if transmission.type else None
    joints = transmission.joints if kind and kind.has_roles else ()
    return [*(("joint", joint) for joint in joints), *(("actuator", actuator) for actuator in transmission.actuators)]


def _fault(reduction: ElementText) -> str | None:
    number = leading_number(reduction.value)
    if number is None:
        return f"is not a number: '{reduction.value}'" if reduction.value else "is empty"
    if number == 0:
        return "is zero"
    if not _PLAIN.fullmatch(reduction.value):
        return f"is read as {number:g}: '{reduction.value}' is not a plain number"
    return None
