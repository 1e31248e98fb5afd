"""UC116."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.urdf.common import Names, is_known, label, replaced, whole_robot_in


@rule(
    "UC116",
    severity=Severity.ERROR,
    authority="urdfdom_headers urdf_model/model.h initTree(): 'parent link [...] of joint [...] not found.'",
    whole_robot=True,
    bad={
        "robot.urdf": """
            <link name="tool"/>
            <joint name="flange" type="fixed">
              <parent link="«Fore»"/>
              <child link="tool"/>
            </joint>
        """,
    },
    good={
        "robot.urdf": """
            <link name="tool"/>
            <joint name="flange" type="fixed">
              <parent link="fore"/>
              <child link="tool"/>
            </joint>
        """,
    },
)
def unknown_link(project: Project) -> Iterator[Finding]:
    """A joint's parent or child is no link of the robot.

    urdfdom cannot build the tree and gives no model. Names are compared letter by letter, with their case and blanks.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    links = Names(link.name for link in robot.links)
    for joint in robot.joints:
        for what, end in (("parent", joint.parent), ("child", joint.child)):
            if end is None or not end.name or end.name in links or not is_known(end.name):
                continue
            meant = links.meant_by(end.name)
            message = f"{what} link '{end.name}' of {label('joint', joint.name)} is not defined"
            fix = replaced(end.at, end.name, meant) if meant else None
            yield Finding(end.at, message + (f"; did you mean '{meant}'?" if meant else ""), fix=fix)
