"""UC130."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC130",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/joint.cpp parseJointSafety(): 'joint safety: no k_velocity'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="continuous">
                  <parent link="fore"/><child link="tool"/>
                  «<safety_controller k_position="10"/>»
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
                  <safety_controller k_position="10" k_velocity="10"/>
                </joint>
            """,
        },
    ],
)
def safety_without_k_velocity(project: Project) -> Iterator[Finding]:
    """<safety_controller> without k_velocity.

    urdfdom rejects the whole robot. The other attributes are optional.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        safety = next(joint.tag.named("safety_controller"), None)
        if safety and "k_velocity" not in safety.attributes:
            yield Finding(safety.at, f"<safety_controller> of {label('joint', joint.name)} has no 'k_velocity'")
