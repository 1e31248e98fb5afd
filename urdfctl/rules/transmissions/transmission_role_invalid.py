"""UC214."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.robot import Transmission, TransmissionEnd
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, is_whole
from urdfctl.rules.transmissions.common import on_hardware, read_transmissions
from urdfctl.rules.transmissions.facts import ROLES, TYPES


@rule(
    "UC214",
    runtime="refuses",
    because="only the loader of real hardware does",
    severity=Severity.WARNING,
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/differential_transmission_loader.cpp, "
    "four_bar_linkage_transmission_loader.cpp: 'does not specify the required <role> element.', 'does not "
    "specify a valid <role> element.', 'must have different roles.'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="wrist_trans">
                  <type>transmission_interface/DifferentialTransmission</type>
                  <joint name="shoulder">
                    <role>joint1</role>
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <joint name="elbow">
                    <role>«joint1»</role>
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
        {
            "options": "--distro=noetic",
            "robot.urdf": """
                <transmission name="arm_trans">
                  <type>transmission_interface/FourBarLinkageTransmission</type>
                  <joint name="shoulder"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface><role>joint1</role></joint>
                  <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface><role>«joint3»</role></joint>
                  <actuator name="shoulder_motor"><role>actuator1</role><mechanicalReduction>1</mechanicalReduction></actuator>
                  <actuator name="elbow_motor"><role>«motor2»</role><mechanicalReduction>1</mechanicalReduction></actuator>
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
        {
            "options": "--distro=noetic",
            "robot.urdf": """
                <transmission name="arm_trans">
                  <type>transmission_interface/FourBarLinkageTransmission</type>
                  <joint name="shoulder"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface><role>joint1</role></joint>
                  <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface><role>joint2</role></joint>
                  <actuator name="shoulder_motor"><role>actuator1</role><mechanicalReduction>1</mechanicalReduction></actuator>
                  <actuator name="elbow_motor"><role>actuator2</role><mechanicalReduction>1</mechanicalReduction></actuator>
                </transmission>
            """,
        },
    ],
)
def transmission_role_invalid(project: Project) -> Iterator[Finding]:
    """Missing, invalid or duplicate role in a transmission.

    A differential or four-bar linkage transmission has the joints joint1 and joint2 and the actuators actuator1 and
    actuator2. If a role is missing, empty, unknown or used twice, the loader of real hardware stops. It loads neither
    this transmission nor the later ones.
    """
    for transmission in read_transmissions(project):
        kind = TYPES.get(transmission.type.value) if transmission.type else None
        if kind is not None and kind.has_roles:
            yield from _faults(project, transmission, "joint", transmission.joints)
            yield from _faults(project, transmission, "actuator", transmission.actuators)


def _faults(
    project: Project, transmission: Transmission, kind: str, ends: tuple[TransmissionEnd, ...]
) -> Iterator[Finding]:
    severity = on_hardware(project)
    expected = " or ".join(f"'{role}'" for role in ROLES[kind])
    seen: dict[str, TransmissionEnd] = {}
    for end in ends:
        owner = f"{kind} '{end.name}' of {transmission.label}"
        role = end.role
        if role is None:
            if is_whole(project, end.at):
                yield Finding(end.at, f"{owner} has no <role>; use {expected}", severity=severity)
        elif not is_known(role.value):
            continue
        elif role.value not in ROLES[kind]:
            problem = f"has unknown role '{role.value}'" if role.value else "has an empty <role>"
            yield Finding(role.at.content, f"{owner} {problem}; use {expected}", severity=severity)
        elif role.value in seen:
            notes = (Note(f"{kind} '{seen[role.value].name}' has this role", seen[role.value].at),)
            both = expected.replace(" or ", " and ")
            message = f"{owner} has the same role '{role.value}' as another {kind}; use {both}"
            yield Finding(role.at.content, message, notes, severity=severity)
        else:
            seen[role.value] = end
