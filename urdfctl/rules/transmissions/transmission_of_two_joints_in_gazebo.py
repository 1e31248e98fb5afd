"""UC216."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.gazebo_ros1 import in_gazebo
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.transmissions.common import read_transmissions


@rule(
    "UC216",
    runtime="crashes",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'has more than one joint. Currently "
    "the default robot hardware simulation  interface only supports one.'",
    options=("--simulator=gazebo-classic",),
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
def transmission_of_two_joints_in_gazebo(project: Project) -> Iterator[Finding]:
    """Transmission with several joints in Gazebo.

    Gazebo's hardware simulation skips the transmission but keeps its slots. It then confuses the later joints, and
    reads past the end of its list. It may crash, or continue with the wrong joints.
    """
    if in_gazebo(project) is not Severity.ERROR:
        return
    severity = Severity.ERROR if project.named_simulator else Severity.WARNING
    for transmission in read_transmissions(project):
        kept = transmission.kept_joints
        if len(kept) > 1:
            message = f"{transmission.label} has {len(kept)} joints; Gazebo's hardware simulation supports only 1"
            notes = [Note(f"joint '{joint.name}' is here", joint.at) for joint in kept[1:]]
            yield Finding(transmission.at, message, tuple(notes), severity=severity)
