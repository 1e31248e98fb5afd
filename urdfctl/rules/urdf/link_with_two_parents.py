"""UC107."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Joint
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in


@rule(
    "UC107",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="urdfdom_headers urdf_model/model.h initTree(): child_link->setParent(parent_link) overwrites an earlier parent",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <joint name="strut" type="fixed">
                  <parent link="base"/><child link="«fore»"/>
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="strut_link"/>
                <joint name="strut" type="fixed">
                  <parent link="base"/><child link="strut_link"/>
                </joint>
            """,
        },
    ],
)
def link_with_two_parents(project: Project) -> Iterator[Finding]:
    """Link is the child of two joints.

    A URDF describes a tree. urdfdom silently keeps one of the two joints as the link's parent. KDL and Gazebo then see
    the link below both joints, or below only one of them.
    """
    robot = robot_in(project)
    first: dict[str, Joint] = {}
    for joint in robot.joints if robot else ():
        child = joint.child
        if child is None or not child.name or not is_known(child.name):
            continue
        other = first.setdefault(child.name, joint)
        if other is joint or other.name == joint.name or other.child is None:
            continue
        parents = f"{label('joint', joint.name)} and {label('joint', other.name)}"
        message = f"link '{child.name}' is the child of both {parents}; a link has one parent"
        yield Finding(child.at, message, (Note("the first joint names it here", other.child.at),))
