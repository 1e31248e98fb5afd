"""UC515."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import Names, is_known, replaced, whole_robot_in
from urdfctl.rules.simulation.common import default_joints, loaded, named_joints


@rule(
    "UC515",
    severity=Severity.WARNING,
    whole_robot=True,
    in_library=False,
    authority="gazebo_plugins gazebo_ros_utils.h: 'couldn't get wheel hinge joint named'; gazebo_ros_diff_drive.cpp (ROS 2): "
    "'Joint [elbw] not found, plugin will not work.'; gz-sim DiffDrive.cc: 'Failed to find left joint'",
    bad={
        "robot.urdf": """
            <gazebo>
              <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                <leftJoint>«shouldr»</leftJoint>
                <rightJoint>elbow</rightJoint>
                <wheelSeparation>0.3</wheelSeparation>
                <wheelDiameter>0.1</wheelDiameter>
              </plugin>
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
                <leftJoint>shoulder</leftJoint>
                <rightJoint>elbow</rightJoint>
                <wheelSeparation>0.3</wheelSeparation>
                <wheelDiameter>0.1</wheelDiameter>
              </plugin>
            </gazebo>
        """,
    },
)
def plugin_joint_unknown(project: Project) -> Iterator[Finding]:
    """A plugin names a joint that the robot does not have, or that Gazebo merges away.

    A drive without its joint does not work; in ROS 1 Gazebo ends. Joints of type fixed are gone in Gazebo, which makes
    one link of two.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    names = Names(joint.name for joint in robot.joints)
    fixed = {joint.name for joint in robot.joints if joint.type == "fixed"} - {
        gazebo.reference for gazebo in robot.gazebos if any(child.name in _KEEPING for child in gazebo.tag.children)
    }
    for one in loaded(project):
        severity = Severity.ERROR if one.moves_joints else None
        for name, place in named_joints(one):
            if not is_known(name) or "::" in name or (name in names and name not in fixed):
                continue
            if name in fixed:
                message = f"joint '{name}' of '{one.filename}' is fixed, and merged away in Gazebo"
                yield Finding(place, message, severity=Severity.WARNING if one.moves_joints else Severity.INFO)
                continue
            meant = names.meant_by(name)
            hint = f"; did you mean '{meant}'?" if meant else ""
            fix = replaced(place, name, meant) if meant else None
            message = f"'{one.filename}' names joint '{name}', which the robot does not have{hint}"
            yield Finding(place, message, fix=fix, severity=severity)
        for setting, default in default_joints(project, one):
            if default not in names:
                message = f"'{one.filename}' has no <{setting}>, and the robot no joint '{default}', its default"
                yield Finding(one.plugin.at, message, (Note(f"<{setting}> names a joint"),), severity=severity)


_KEEPING = {"preserveFixedJoint", "disableFixedJointLumping"}
"""What keeps a fixed joint in Gazebo, in <gazebo reference="joint">."""
