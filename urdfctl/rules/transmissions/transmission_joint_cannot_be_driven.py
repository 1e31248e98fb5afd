"""UC207."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.model.robot import Joint
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.transmissions.common import in_gazebo, joints_by_name, known_joints


@rule(
    "UC207",
    severity=Severity.WARNING,
    distros=ROS1,
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: 'This robot has a joint named "
    '"<joint>" which is not in the gazebo model.\'',
    bad={
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
    good={
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
)
def transmission_joint_cannot_be_driven(project: Project) -> Iterator[Finding]:
    """A transmission drives a joint of a type that has no single axis: fixed, floating or planar.

    Gazebo joins the links of a fixed joint into one and has no joint of the other two types; its hardware
    simulation then stops, and there is no controller manager at all.
    """
    joints = joints_by_name(project)
    for transmission, joint, name in known_joints(project):
        meant = joints.get(name)
        if meant is None or meant.type not in ("fixed", "floating", "planar"):
            continue
        message = (
            f"{transmission.label} drives joint '{name}', which is {meant.type}: "
            f"it takes a revolute, continuous or prismatic one"
        )
        severity = None if _is_kept(project, meant) else in_gazebo(project)
        yield Finding(joint.at["name"], message, (Note("the joint is defined here", meant.at),), severity=severity)


def _is_kept(project: Project, joint: Joint) -> bool:
    """Whether Gazebo is told to keep a fixed joint."""
    words = ("preserveFixedJoint", "disableFixedJointLumping")
    gazebos = project.robot.gazebos if project.robot else ()
    return joint.type == "fixed" and any(
        tag.text.strip() in ("true", "1")
        for gazebo in gazebos
        if gazebo.reference == joint.name
        for tag in gazebo.tag.children
        if tag.name in words
    )
