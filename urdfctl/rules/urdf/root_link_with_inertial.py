"""UC138."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.urdf.tree import Tree


@rule(
    "UC138",
    runtime="warns",
    severity=Severity.INFO,
    authority="kdl_parser kdl_parser.cpp: 'The root link ... has an inertia specified in the URDF, "
    "but KDL does not support a root link with an inertia.'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <robot name="cart">
                  <link name="base">
                    «<inertial>»
                      <mass value="5"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
                    </inertial>
                  </link>
                  <link name="mast"/>
                  <joint name="mast_joint" type="fixed"><parent link="base"/><child link="mast"/></joint>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <robot name="cart">
                  <link name="base_footprint"/>
                  <link name="base">
                    <inertial>
                      <mass value="5"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
                    </inertial>
                  </link>
                  <joint name="base_joint" type="fixed"><parent link="base_footprint"/><child link="base"/></joint>
                </robot>
            """,
        },
    ],
)
def root_link_with_inertial(project: Project) -> Iterator[Finding]:
    """Root link with <inertial>.

    robot_state_publisher prints a warning, and dynamics computed with KDL ignore this mass. Nothing else is affected.
    """
    robot = whole_robot_in(project)
    if robot is None or not robot.joints:
        return
    roots = Tree(robot).roots
    if len(roots) == 1 and roots[0].inertials:
        root = roots[0]
        message = f"root link '{root.name}' has an <inertial>, which KDL ignores"
        fix = Fix(f"add a root link without <inertial>, and connect '{root.name}' to it with a fixed joint")
        yield Finding(root.inertials[0].at, message, fix=fix)
