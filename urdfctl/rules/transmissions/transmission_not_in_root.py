"""UC221."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Fix, Project, Severity, rule


@rule(
    "UC221",
    severity=Severity.ERROR,
    runtime="drops",
    distros=ROS1,
    authority="ros_control transmission_interface/src/transmission_parser.cpp reads "
    'root->FirstChildElement("transmission") and its siblings only',
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  «<transmission name="elbow_trans">»
                    <type>transmission_interface/SimpleTransmission</type>
                    <joint name="elbow">
                      <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                    </joint>
                    <actuator name="elbow_motor">
                      <mechanicalReduction>1</mechanicalReduction>
                    </actuator>
                  </transmission>
                </gazebo>
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
def transmission_not_in_root(project: Project) -> Iterator[Finding]:
    """Transmission is not directly under `<robot>`.

    ros_control reads only transmissions directly under the root element. Controllers do not find the joint of this one.
    """
    robot = project.robot
    if robot is None:
        return
    for transmission in robot.nested_transmissions:
        if transmission.parent == "plugin" or ":" in transmission.parent or transmission.is_pr2:
            continue
        if transmission.joints or transmission.type:
            where = transmission.parent
            message = f"{transmission.label} is inside <{where}>; ros_control reads it only directly under <robot>"
            yield Finding(transmission.at, message, fix=Fix("move it directly under <robot>"))
    for control in robot.ros2_controls if project.ros == 1 else ():
        for inner in control.transmissions:
            if inner.is_ros1:
                message = (
                    f"transmission '{inner.name or ''}' is inside <ros2_control>, which ROS 1 ignores; "
                    f"it belongs directly under <robot>"
                )
                yield Finding(inner.at, message, fix=Fix("move it directly under <robot>"))
