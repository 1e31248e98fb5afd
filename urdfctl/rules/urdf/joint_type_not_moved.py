"""UC122."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC122",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="kdl_parser kdl_parser.cpp: \"Converting unknown joint type of joint '...' into a fixed joint\"; "
    "sdformat 12 src/parser_urdf.cc CreateJoint() creates no joint",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="«planar»">
                  <parent link="fore"/><child link="tool"/>
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="continuous">
                  <parent link="fore"/><child link="tool"/>
                </joint>
            """,
        },
    ],
)
def joint_type_not_moved(project: Project) -> Iterator[Finding]:
    """Floating or planar joint.

    urdfdom accepts these types, but most other tools do not. robot_state_publisher treats the joint as fixed. Gazebo
    creates no joint, and rejects the model from sdformat 12 on. MuJoCo has free joints: there this is only worth knowing.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        if joint.type in ("floating", "planar"):
            message = f"{label('joint', joint.name)} is {joint.type}; robot_state_publisher treats it as fixed"
            in_gazebo = project.may_be_simulated and project.simulator != "mujoco"
            if in_gazebo:
                message += ", and Gazebo creates no joint for it"
            severity = None if in_gazebo else Severity.INFO
            yield Finding(joint.at["type"], message, severity=severity)
