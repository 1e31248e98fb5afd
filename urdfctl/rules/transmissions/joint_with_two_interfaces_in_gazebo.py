"""UC217."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.transmissions.common import in_gazebo, named_joints


@rule(
    "UC217",
    severity=Severity.WARNING,
    in_library=False,
    distros=since("indigo"),
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'specifies multiple hardware "
    "interfaces. Currently the default robot hardware simulation interface only supports one. Using the "
    "first entry'",
    options=("--simulator=gazebo-classic",),
    bad={
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
    good={
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
)
def joint_with_two_interfaces_in_gazebo(project: Project) -> Iterator[Finding]:
    """Gazebo is to simulate a joint that has several hardware interfaces.

    Real hardware offers all of them. Gazebo's hardware simulation takes the first and warns; controllers of the
    others find no joint.
    """
    if in_gazebo(project) is not Severity.ERROR:
        return
    for transmission, joint, name in named_joints(project):
        for interface in joint.named_interfaces[1:]:
            first = joint.named_interfaces[0].value
            message = (
                f"Gazebo's hardware simulation does not take the interface '{interface.value}' of joint '{name}' of "
                f"{transmission.label}: it takes the first one, '{first}'"
            )
            yield Finding(interface.at, message)
