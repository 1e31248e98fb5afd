"""UC218."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.robot import TransmissionEnd
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.common import listed, on_hardware, read_transmissions


@rule(
    "UC218",
    runtime="refuses",
    because="only the loader of real hardware does",
    severity=Severity.WARNING,
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_interface_loader.cpp: 'It has joints with "
    "different hardware interfaces. This is currently unsupported.'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="wrist_trans">
                  <type>transmission_interface/DifferentialTransmission</type>
                  <joint name="shoulder">
                    <role>joint1</role>
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  «<joint name="elbow">»
                    <role>joint2</role>
                    <hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>
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
def transmission_joints_with_different_interfaces(project: Project) -> Iterator[Finding]:
    """Joints of a transmission with different hardware interfaces.

    The loader of real hardware requires the same interfaces for all joints, in any order. It stops at this
    transmission, and does not load the later ones either.
    """
    for transmission in read_transmissions(project):
        kept = transmission.kept_joints
        for joint in kept[1:]:
            interfaces, first = _interfaces(joint), _interfaces(kept[0])
            if interfaces != first and is_known(*interfaces, *first):
                has = listed(sorted(interfaces))
                message = f"joint '{joint.name}' of {transmission.label} has {has}, unlike joint '{kept[0].name}'"
                note = Note(f"joint '{kept[0].name}' has {listed(sorted(first))}", kept[0].at)
                yield Finding(joint.at, message, (note,), severity=on_hardware(project))


def _interfaces(joint: TransmissionEnd) -> set[str]:
    return {interface.value for interface in joint.named_interfaces}
