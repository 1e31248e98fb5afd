"""UC222."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.robot import TransmissionEnd
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.common import listed, read_transmissions
from urdfctl.rules.transmissions.facts import PREFIX


@rule(
    "UC222",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_parser.cpp: the interfaces of <actuator> are "
    "optional and its loaders use those of <joint> ('Optional: No valid hardware interface element found "
    "in actuator')",
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="elbow_motor">
                    «<hardwareInterface>»hardware_interface/PositionJointInterface</hardwareInterface>
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
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
)
def actuator_interface_differs(project: Project) -> Iterator[Finding]:
    """Actuator and joint name different hardware interfaces.

    From indigo on, the joint's interface is used and the actuator's is silently ignored. The robot is not driven as the
    actuator says.
    """
    for transmission in read_transmissions(project):
        joint_interfaces = {name for joint in transmission.joints for name in _names(joint)}
        for actuator in transmission.actuators:
            for interface in actuator.named_interfaces:
                if (
                    joint_interfaces
                    and _short(interface.value) not in joint_interfaces
                    and is_known(interface.value, *joint_interfaces)
                ):
                    message = (
                        f"interface '{interface.value}' of actuator '{actuator.name}' of {transmission.label} "
                        f"is ignored; its joint has {listed(sorted(joint_interfaces))}"
                    )
                    notes = [Note(f"joint '{joint.name}' is here", joint.at) for joint in transmission.kept_joints[:1]]
                    yield Finding(interface.at, message, tuple(notes))


def _names(end: TransmissionEnd) -> list[str]:
    return [_short(interface.value) for interface in end.named_interfaces]


def _short(interface: str) -> str:
    return interface.removeprefix(PREFIX).replace("ActuatorInterface", "JointInterface")
