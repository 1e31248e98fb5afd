"""UC157."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Joint, Link, PartReference
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, label, replaced, robot_in
from urdfctl.source.opaque import UNKNOWN


@rule(
    "UC157",
    runtime="works",
    because="urdfdom rejects the robot with any other prefix",
    severity=Severity.WARNING,
    authority="urdfdom_headers urdf_model/model.h initTree(): 'parent link [...] of joint [...] not found.'",
    bad=[
        {
            "arm.xacro": """
                <robot xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="arm" params="prefix">
                    <link name="${prefix}upper"/>
                    <link name="${prefix}fore"/>
                    <joint name="${prefix}elbow" type="fixed">
                      <parent link="«upper»"/>
                      <child link="${prefix}fore"/>
                    </joint>
                  </xacro:macro>
                </robot>
            """,
        },
    ],
    good=[
        {
            "arm.xacro": """
                <robot xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="arm" params="prefix">
                    <link name="${prefix}upper"/>
                    <link name="${prefix}fore"/>
                    <joint name="base_to_${prefix}upper" type="fixed">
                      <parent link="upper"/>
                      <child link="${prefix}upper"/>
                    </joint>
                    <joint name="${prefix}elbow" type="fixed">
                      <parent link="${prefix}upper"/>
                      <child link="${prefix}fore"/>
                    </joint>
                  </xacro:macro>
                </robot>
            """,
        },
    ],
)
def link_named_without_prefix(project: Project) -> Iterator[Finding]:
    """Joint of a macro names a link without the macro's prefix.

    This works as long as the prefix is empty. With any other prefix, the parent or child link does not exist, and
    urdfdom rejects the whole robot.
    """
    robot = robot_in(project) if project.library else None
    links = {link.name: link for link in robot.links} if robot else {}
    for joint in robot.joints if robot else ():
        ends = (joint.parent, joint.child)
        for kind, end, other in zip(("parent", "child"), ends, reversed(ends), strict=True):
            meant = _prefixed(joint, end, other, links)
            if end is None or meant is None:
                continue
            written = meant.at["name"].span.text
            joint_label = label("joint", joint.at["name"].span.text)
            message = f"{kind} link '{end.name}' of {joint_label} has no prefix; the macro's link is '{written}'"
            note = Note("the link is defined here", meant.at["name"])
            yield Finding(end.at, message, (note,), replaced(end.at, end.name or "", written))


def _prefixed(
    joint: Joint, end: PartReference | None, other: PartReference | None, links: dict[str | None, Link]
) -> Link | None:
    """The link of the same macro that a joint must mean; None if it may mean a link from outside."""
    if end is None or not end.name or not is_known(end.name) or end.name in links:
        return None
    link = links.get(UNKNOWN + end.name)
    if link is None or (other is not None and other.name == link.name):
        return None
    return link if link.at.source is joint.at.source and link.at.call is joint.at.call else None
