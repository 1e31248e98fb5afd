"""UC223."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import is_whole
from urdfctl.rules.transmissions.common import named_joints


@rule(
    "UC223",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=since("indigo"),
    authority="ros_control transmission_interface/src/transmission_parser.cpp: 'Skipping empty hardware interface "
    "element in joint'",
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    «<hardwareInterface/>»
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
def empty_hardware_interface(project: Project) -> Iterator[Finding]:
    """Empty `<hardwareInterface>` beside a valid one.

    ros_control skips it without a visible message. If a second interface was intended, it is missing.
    """
    for transmission, joint, name in named_joints(project):
        for interface in joint.interfaces if joint.named_interfaces else ():
            if not interface.value and is_whole(project, interface.at):
                message = f"joint '{name}' of {transmission.label} has an empty <hardwareInterface>"
                hidden = (Note("a comment precedes the text, so ROS 1's XML reader finds none"),)
                yield Finding(
                    interface.at, message, hidden if interface.hidden else (), Fix("remove it, or name an interface")
                )
