"""UC215."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_whole
from urdfctl.rules.transmissions.common import on_hardware, read_transmissions
from urdfctl.rules.transmissions.facts import TYPES


@rule(
    "UC215",
    runtime="refuses",
    because="only the loader of real hardware does",
    severity=Severity.WARNING,
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_loader.cpp: 'Invalid description for "
    "transmission' ... 'Expected <n> actuators, got <m>.'",
    bad=[
        {
            "robot.urdf": """
                «<transmission name="wrist_trans">»
                  <type>transmission_interface/DifferentialTransmission</type>
                  <joint name="shoulder">
                    <role>joint1</role>
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <joint name="elbow">
                    <role>joint2</role>
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="left_motor">
                    <role>actuator1</role>
                    <mechanicalReduction>50</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <transmission name="wrist_trans">
                  <type>transmission_interface/DifferentialTransmission</type>
                  <joint name="shoulder">
                    <role>joint1</role>
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <joint name="elbow">
                    <role>joint2</role>
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="left_motor">
                    <role>actuator1</role>
                    <mechanicalReduction>50</mechanicalReduction>
                  </actuator>
                  <actuator name="right_motor">
                    <role>actuator2</role>
                    <mechanicalReduction>50</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
)
def transmission_ends_miscounted(project: Project) -> Iterator[Finding]:
    """Wrong number of joints or actuators in a transmission.

    A simple transmission has one of each; a differential transmission and a four-bar linkage have two of each. At any
    other number the loader of real hardware stops, and loads neither this transmission nor the later ones.
    """
    for transmission in read_transmissions(project):
        kind = transmission.type.value if transmission.type else ""
        if kind not in TYPES or not is_whole(project, transmission.at):
            continue
        counts = (
            ("joint", len(transmission.joints), TYPES[kind].joints),
            ("actuator", len(transmission.actuators), TYPES[kind].actuators),
        )
        for end, count, wanted in counts:
            if count not in (0, wanted):
                short = kind.rpartition("/")[2]
                message = f"{transmission.label} has {_counted(count, end)}; a {short} has {_counted(wanted, end)}"
                yield Finding(transmission.at, message, severity=on_hardware(project))


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}" + ("s" if number != 1 else "")
