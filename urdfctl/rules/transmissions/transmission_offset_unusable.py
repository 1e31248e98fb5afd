"""UC213."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.robot import leading_number
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.common import on_hardware, read_transmissions


@rule(
    "UC213",
    runtime="refuses",
    because="only the loader of real hardware does",
    severity=Severity.WARNING,
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_loader.cpp: 'specifies the <offset> element, but "
    "is not a number.'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <offset>«zero»</offset>
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
                    <offset>0.5</offset>
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
def transmission_offset_unusable(project: Project) -> Iterator[Finding]:
    """`<offset>` of a transmission is not a number, or is in the actuator.

    If the offset of a joint is not a number, the loader of real hardware stops. It loads neither this transmission nor
    the later ones. The offset of an actuator is ignored. Gazebo's hardware simulation ignores all offsets.
    """
    for transmission in read_transmissions(project):
        for joint in transmission.joints:
            for offset in joint.offsets[:1]:
                if leading_number(offset.value) is None and is_known(offset.value):
                    problem = f"is not a number: '{offset.value}'" if offset.value else "is empty"
                    message = f"<offset> of joint '{joint.name}' of {transmission.label} {problem}"
                    fix = Fix("write radians or metres, or remove the element (the default is 0)")
                    yield Finding(offset.at.content, message, fix=fix, severity=on_hardware(project))
        for actuator in transmission.actuators:
            for offset in actuator.offsets:
                owner = f"actuator '{actuator.name}' of {transmission.label}"
                message = f"<offset> of {owner} is ignored; it belongs inside <joint>"
                yield Finding(offset.at, message)
