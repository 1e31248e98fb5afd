"""UC217."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.hardware.gazebo_ros1 import in_gazebo
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.transmissions.common import named_joints


@rule(
    "UC217",
    runtime="warns",
    severity=Severity.WARNING,
    in_library=False,
    distros=since("indigo"),
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'specifies multiple hardware "
    "interfaces. Currently the default robot hardware simulation interface only supports one. Using the "
    "first entry'",
    options=("--simulator=gazebo-classic",),
    bad=[
        {
            "robot.urdf": """
                <transmission name="elbow_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="elbow">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                    «<hardwareInterface>»hardware_interface/PositionJointInterface</hardwareInterface>
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
def joint_with_two_interfaces_in_gazebo(project: Project) -> Iterator[Finding]:
    """Joint with several hardware interfaces in Gazebo.

    Real hardware offers all of them. Gazebo's hardware simulation uses the first one and prints a warning. Controllers
    of the other interfaces do not find the joint.
    """
    if in_gazebo(project) is not Severity.ERROR:
        return
    for transmission, joint, name in named_joints(project):
        for interface in joint.named_interfaces[1:]:
            first = joint.named_interfaces[0].value
            message = (
                f"interface '{interface.value}' of joint '{name}' of {transmission.label} is ignored; "
                f"Gazebo's hardware simulation uses only the first one, '{first}'"
            )
            yield Finding(interface.at, message)
