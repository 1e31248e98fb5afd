"""UC105."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.urdf.tree import Tree


@rule(
    "UC105",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom_headers urdf_model/model.h initRoot(): 'Two root links found: [a] and [b]'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="«tool»"/>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="flange" type="fixed">
                  <parent link="fore"/><child link="tool"/>
                </joint>
            """,
        },
    ],
)
def several_root_links(project: Project) -> Iterator[Finding]:
    """More than one root link.

    A robot is one tree with one root link: the link that is not the child of any joint. urdfdom rejects a robot with
    two, even if all its joints are valid.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    tree = Tree(robot)
    if tree.has_unknown_ends:
        return  # other rules report the unknown link; urdfdom fails there before it looks for the root
    roots = tree.roots
    if len(roots) < 2:  # noqa: PLR2004
        return
    main = max(roots, key=lambda link: len(tree.below(link.name or "")))
    for root in roots:
        if root is not main and root.name:
            message = f"link '{root.name}' is not the child of any joint, so it is a second root besides '{main.name}'"
            yield Finding(root.at["name"], message, (Note(f"root link '{main.name}' is here", main.at["name"]),))
