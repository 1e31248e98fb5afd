"""UC213."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.parts import leading_number
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.transmissions.common import on_hardware, read_transmissions


@rule(
    "UC213",
    severity=Severity.WARNING,
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_loader.cpp: 'specifies the <offset> element, but "
    "is not a number.'",
    bad={
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
    good={
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
)
def transmission_offset_unusable(project: Project) -> Iterator[Finding]:
    """The `<offset>` of a transmission's joint is not a number, or it stands in the actuator.

    At one that is not a number the loader of real hardware stops, and loads no transmission from there on. Nobody
    reads the offset of an actuator. Gazebo's hardware simulation looks at none.
    """
    for transmission in read_transmissions(project):
        for joint in transmission.joints:
            for offset in joint.offsets[:1]:
                if leading_number(offset.value) is None and is_known(offset.value):
                    written = f"'{offset.value}' is" if offset.value else "an empty text is"
                    message = f"the offset of joint '{joint.name}' of {transmission.label}: {written} not a number"
                    fix = Fix("write radians or metres, or leave the element out: it is 0 then")
                    yield Finding(offset.at.content, message, fix=fix, severity=on_hardware(project))
        for actuator in transmission.actuators:
            for offset in actuator.offsets:
                who = f"actuator '{actuator.name}' of {transmission.label}"
                message = f"the <offset> of {who} is not read; it belongs inside <joint>"
                yield Finding(offset.at, message)
