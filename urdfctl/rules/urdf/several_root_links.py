"""UC105."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.urdf.tree import Tree


@rule(
    "UC105",
    severity=Severity.ERROR,
    authority="urdfdom_headers urdf_model/model.h initRoot(): 'Two root links found: [a] and [b]'",
    whole_robot=True,
    bad={
        "robot.urdf": """
            <link name="«tool»"/>
        """,
    },
    good={
        "robot.urdf": """
            <link name="tool"/>
            <joint name="flange" type="fixed">
              <parent link="fore"/><child link="tool"/>
            </joint>
        """,
    },
)
def several_root_links(project: Project) -> Iterator[Finding]:
    """A link is the child of no joint, beside the one that is the root.

    A robot is one tree with one root. urdfdom gives no model for two, however many joints are right.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    tree = Tree(robot)
    if tree.has_unknown_ends:
        return  # which link was meant is told there; urdfdom does not get as far as the root
    roots = tree.roots
    if len(roots) < 2:  # noqa: PLR2004
        return
    main = max(roots, key=lambda link: len(tree.below(link.name or "")))
    for root in roots:
        if root is not main and root.name:
            message = f"link '{root.name}' is the child of no joint, so it is a second root beside '{main.name}'"
            yield Finding(root.at["name"], message, (Note(f"link '{main.name}' is a root too", main.at["name"]),))
