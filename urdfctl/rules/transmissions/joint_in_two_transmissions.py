"""UC208."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.robot import Transmission, TransmissionEnd
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.transmissions.common import known_joints
from urdfctl.rules.transmissions.facts import PREFIX


@rule(
    "UC208",
    severity=Severity.WARNING,
    runtime="misbehaves",
    in_library=False,
    distros=ROS1,
    authority="ros_control hardware_interface/include/hardware_interface/internal/resource_manager.h: 'Replacing "
    "previously registered handle'",
    bad=[
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
                <transmission name="elbow_trans_2">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="«elbow»">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor_2">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <transmission name="shoulder_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="shoulder">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="shoulder_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
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
def joint_in_two_transmissions(project: Project) -> Iterator[Finding]:
    """Joint in two transmissions.

    The handle of the second transmission replaces that of the first. If their interfaces differ, both exist, and two
    controllers can command the joint at the same time.
    """
    seen: dict[str, tuple[Transmission, TransmissionEnd]] = {}
    for transmission, joint, name in known_joints(project):
        first, before = seen.setdefault(name, (transmission, joint))
        if first is transmission:
            continue
        notes = [Note(f"it is first used in {first.label}", before.at["name"])]
        if _interfaces(before) != _interfaces(joint):
            notes.append(
                Note("their interfaces differ: two controllers can claim the joint and command it at the same time")
            )
        message = f"joint '{name}' of {transmission.label} is already in another transmission"
        yield Finding(joint.at["name"], message, tuple(notes))


def _interfaces(joint: TransmissionEnd) -> set[str]:
    return {interface.value.removeprefix(PREFIX) for interface in joint.named_interfaces}
