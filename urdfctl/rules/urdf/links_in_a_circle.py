"""UC106."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, whole_robot_in
from urdfctl.rules.urdf.tree import Tree, parent_of


@rule(
    "UC106",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom_headers urdf_model/model.h initRoot(): 'No root link found. The robot xml is not a valid tree.'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <robot name="ring">
                  <link name="a"/>
                  <link name="b"/>
                  <joint name="there" type="fixed"><parent link="a"/><child link="«b»"/></joint>
                  <joint name="back" type="fixed"><parent link="b"/><child link="a"/></joint>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <robot name="row">
                  <link name="a"/>
                  <link name="b"/>
                  <joint name="there" type="fixed"><parent link="a"/><child link="b"/></joint>
                </robot>
            """,
        },
    ],
)
def links_in_a_circle(project: Project) -> Iterator[Finding]:
    """Links form a loop.

    If every link is a child, there is no root, and urdfdom rejects the whole robot. It does not notice a loop beside a
    valid tree: the links of the loop are then part of the model, but connected to nothing.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    tree = Tree(robot)
    no_root = not tree.roots
    for loop in tree.circles():
        names = [parent_of(joint) for joint in loop]
        problem = f"link '{names[0]}' is its own child"
        if len(names) > 1:
            problem = f"links {in_words(names)} form a loop"
        effect = "so the robot has no root link" if no_root else "and nothing connects it to the rest of the robot"
        at = loop[0].child.at if loop[0].child else loop[0].at
        yield Finding(at, f"{problem}, {effect}", severity=None if no_root else Severity.WARNING)
