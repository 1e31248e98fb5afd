"""UC128."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC128",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/joint.cpp parseJointDynamics(): "
    "'joint dynamics element specified with no damping and no friction'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="continuous">
                  <parent link="fore"/><child link="tool"/>
                  «<dynamics/>»
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
                  <dynamics damping="0.1"/>
                </joint>
            """,
        },
    ],
)
def dynamics_empty(project: Project) -> Iterator[Finding]:
    """<dynamics> without damping and friction.

    urdfdom rejects the whole robot.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        dynamics = next(joint.tag.named("dynamics"), None)
        if dynamics and not {"damping", "friction"} & set(dynamics.attributes):
            problem = "has neither 'damping' nor 'friction'; add one or remove the element"
            yield Finding(dynamics.at, f"<dynamics> of {label('joint', joint.name)} {problem}")
