"""UC119."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC119",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/joint.cpp parseJointMimic(): 'joint mimic: no mimic joint specified'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="finger"/>
                <joint name="finger_joint" type="prismatic">
                  <parent link="fore"/><child link="finger"/>
                  <limit lower="-1" upper="1" effort="1" velocity="1"/>
                  «<mimic multiplier="-1"/>»
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
                  <mimic joint="elbow" multiplier="-1"/>
                </joint>
            """,
        },
    ],
)
def mimic_without_joint(project: Project) -> Iterator[Finding]:
    """<mimic> without a joint.

    urdfdom rejects the whole robot. It accepts an empty name, but the joint then follows nothing.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        if joint.mimic and joint.mimic.joint == "":
            message = f"<mimic> of {label('joint', joint.name)} has an empty 'joint'; name the joint to follow"
            yield Finding(joint.mimic.at["joint"], message, severity=Severity.WARNING)
        elif joint.mimic and joint.mimic.joint is None:
            message = f"<mimic> of {label('joint', joint.name)} has no 'joint'; name the joint to follow"
            yield Finding(joint.mimic.at, message)
