"""UC129."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Number
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC129",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="wiki.ros.org urdf/XML/joint: damping and friction are physical values of the joint; urdfdom joint.cpp does not check them",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="continuous">
                  <parent link="fore"/><child link="tool"/>
                  <dynamics damping="«-0.1»"/>
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
def dynamics_negative(project: Project) -> Iterator[Finding]:
    """Negative joint damping or friction.

    urdfdom accepts it. In simulation, the joint accelerates itself until the robot flies apart.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        dynamics = next(joint.tag.named("dynamics"), None)
        for name in ("damping", "friction") if dynamics else ():
            text = dynamics.attributes.get(name, "") if dynamics else ""
            if dynamics and (Number(text, dynamics.at, name).value or 0) < 0:
                message = f"'{name}' of <dynamics> of {label('joint', joint.name)} is negative: {text}"
                yield Finding(dynamics.at[name], message)
