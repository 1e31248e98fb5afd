"""UC207."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.gazebo_ros1 import in_gazebo
from urdfctl.model.robot import Joint
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.transmissions.common import joints_by_name, known_joints


@rule(
    "UC207",
    runtime="refuses",
    because="only Gazebo does, and the robot may not run there",
    severity=Severity.WARNING,
    distros=ROS1,
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'This robot has a joint named "
    '"<joint>" which is not in the gazebo model.\'',
    bad=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="tool_mount" type="fixed"><parent link="fore"/><child link="tool"/></joint>
                <transmission name="tool_trans">
                  <type>transmission_interface/SimpleTransmission</type>
                  <joint name="«tool_mount»">
                    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
                  </joint>
                  <actuator name="tool_motor">
                    <mechanicalReduction>1</mechanicalReduction>
                  </actuator>
                </transmission>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="tool_mount" type="fixed"><parent link="fore"/><child link="tool"/></joint>
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
def transmission_joint_cannot_be_driven(project: Project) -> Iterator[Finding]:
    """Transmission drives a fixed, floating or planar joint.

    These types have no single axis. Gazebo merges the links of a fixed joint, and has no floating or planar joints. Its
    hardware simulation then stops, and there is no controller manager.
    """
    joints = joints_by_name(project)
    for transmission, joint, name in known_joints(project):
        driven = joints.get(name)
        if driven is None or driven.type not in ("fixed", "floating", "planar"):
            continue
        message = (
            f"{transmission.label} drives joint '{name}', which is {driven.type}; "
            f"it needs a revolute, continuous or prismatic joint"
        )
        severity = None if _is_kept(project, driven) else in_gazebo(project)
        yield Finding(joint.at["name"], message, (Note("the joint is defined here", driven.at),), severity=severity)


def _is_kept(project: Project, joint: Joint) -> bool:
    """Whether a <gazebo> element makes Gazebo keep a fixed joint."""
    options = ("preserveFixedJoint", "disableFixedJointLumping")
    gazebos = project.robot.gazebos if project.robot else ()
    return joint.type == "fixed" and any(
        tag.text.strip() in ("true", "1")
        for gazebo in gazebos
        if gazebo.reference == joint.name
        for tag in gazebo.tag.children
        if tag.name in options
    )
