"""UC220."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.transmissions.common import read_transmissions, takes_empty_names


@rule(
    "UC220",
    runtime="drops",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="ros_control transmission_interface/src/transmission_parser.cpp: 'No name attribute specified for "
    "transmission.', 'Empty name attribute specified for transmission.'",
    bad=[
        {
            "robot.urdf": """
                «<transmission>»
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
def transmission_without_name(project: Project) -> Iterator[Finding]:
    """Transmission without a name.

    ros_control skips it, so no controller can claim its joint.
    """
    for transmission in read_transmissions(project):
        if transmission.name or (transmission.name is not None and takes_empty_names(project)):
            continue
        joint = next((joint.name for joint in transmission.joints if joint.name), "joint")
        problem = "has no 'name'" if transmission.name is None else "has an empty 'name'"
        yield Finding(transmission.at, f"{transmission.label} {problem}", fix=Fix(f'add name="{joint}_trans"'))
