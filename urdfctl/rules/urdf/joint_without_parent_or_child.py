"""UC115."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC115",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom_headers urdf_model/model.h initTree(): 'Joint [...] is missing a parent and/or child link specification.'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                «<joint name="flange" type="fixed">»
                  <parent link="fore"/>
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="flange" type="fixed">
                  <parent link="fore"/>
                  <child link="tool"/>
                </joint>
            """,
        },
    ],
)
def joint_without_parent_or_child(project: Project) -> Iterator[Finding]:
    """Joint without a parent or child link.

    urdfdom cannot build the tree and rejects the whole robot.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        for name, end in (("parent", joint.parent), ("child", joint.child)):
            if end is None:
                yield Finding(joint.at, f'{label("joint", joint.name)} has no <{name} link="..."/>')
            elif not end.name:
                problem = "has no 'link'" if end.name is None else "has an empty 'link'"
                yield Finding(end.at, f"<{name}> of {label('joint', joint.name)} {problem}")
