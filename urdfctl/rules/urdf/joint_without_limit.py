"""UC123."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC123",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/joint.cpp parseJoint(): 'Joint [...] is of type REVOLUTE but it does not specify limits'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                «<joint name="wrist" type="revolute">»
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
def joint_without_limit(project: Project) -> Iterator[Finding]:
    """Revolute or prismatic joint without <limit>.

    urdfdom rejects the whole robot. A joint that turns without end is continuous and needs no <limit>.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        if joint.type in ("revolute", "prismatic") and joint.limit is None:
            hint = "; add one, or make the joint continuous" if joint.type == "revolute" else "; add one"
            message = f"{label('joint', joint.name)} is {joint.type} but has no <limit>{hint}"
            yield Finding(joint.at, message)
