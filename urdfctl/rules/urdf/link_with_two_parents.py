"""UC107."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Joint
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in


@rule(
    "UC107",
    severity=Severity.WARNING,
    authority="urdfdom_headers urdf_model/model.h initTree(): child_link->setParent(parent_link), over whatever was there",
    whole_robot=True,
    bad={
        "robot.urdf": """
            <joint name="strut" type="fixed">
              <parent link="base"/><child link="«fore»"/>
            </joint>
        """,
    },
    good={
        "robot.urdf": """
            <link name="strut_link"/>
            <joint name="strut" type="fixed">
              <parent link="base"/><child link="strut_link"/>
            </joint>
        """,
    },
)
def link_with_two_parents(project: Project) -> Iterator[Finding]:
    """A link is the child of two joints.

    URDF describes trees. urdfdom says nothing and keeps one of the two as the link's parent; KDL and Gazebo then see the
    link below both, or below one of them only.
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
        message = (
            f"link '{child.name}' is the child of {label('joint', joint.name)} and of {label('joint', other.name)}"
        )
        yield Finding(child.at, message, (Note("the first one is here", other.child.at),))
