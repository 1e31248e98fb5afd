"""UC117."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, label, robot_in, whole_robot_in
from urdfctl.rules.links_for_joints import joint_meant_by, links_called
from urdfctl.rules.urdf.common import known_part
from urdfctl.rules.written import at_written


@rule(
    "UC117",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="urdfdom urdf_parser/src/joint.cpp parseJointMimic() accepts any name; joint_state_publisher and ros2_control look it up",
    bad=[
        {
            "robot.urdf": """
                <link name="finger"/>
                <joint name="finger_joint" type="prismatic">
                  <parent link="fore"/><child link="finger"/>
                  <limit lower="-1" upper="1" effort="1" velocity="1"/>
                  <mimic joint="«elbo»"/>
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="finger">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="finger_joint" type="prismatic">
                  <parent link="fore"/><child link="finger"/>
                  <limit lower="-1" upper="1" effort="1" velocity="1"/>
                  <mimic joint="elbow"/>
                </joint>
            """,
        },
    ],
)
def unknown_mimic_joint(project: Project) -> Iterator[Finding]:
    """Joint mimics an unknown joint.

    urdfdom does not check it. The joint has nothing to follow: it stays where it is. If it is in `<ros2_control>`, the
    controller manager rejects the description.
    """
    robot = robot_in(project) if project.library else whole_robot_in(project)
    if robot is None or not (project.complete or project.library):
        return
    names = [joint.name or "" for joint in robot.joints]
    if not all(known_part(name) for name in names):
        return  # a joint of the library may have any name
    joints = KnownNames(names)
    for joint in robot.joints:
        mimic = joint.mimic
        if mimic is None or not mimic.joint or mimic.joint in joints or not known_part(mimic.joint):
            continue
        meant, is_sure = joint_meant_by(robot, mimic.joint, joints.meant_by(mimic.joint), (joint.name,))
        hint = f"; did you mean '{meant}'?" if meant else ""
        message = f"{label('joint', joint.name)} mimics unknown joint '{mimic.joint}'{hint}"
        correct = meant if meant and is_known(meant) else None
        notes = tuple(links_called(robot, mimic.joint))
        is_sure = is_sure or joints.is_sure(mimic.joint, correct)
        yield at_written(mimic.at["joint"], mimic.joint, correct, message, notes, safe=is_sure)
