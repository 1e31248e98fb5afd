"""UC116."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, label, replaced, whole_robot_in
from urdfctl.rules.urdf.tree import child_of
from urdfctl.rules.written import where_written


@rule(
    "UC116",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom_headers urdf_model/model.h initTree(): 'parent link [...] of joint [...] not found.'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="flange" type="fixed">
                  <parent link="«Fore»"/>
                  <child link="tool"/>
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
def unknown_link(project: Project) -> Iterator[Finding]:
    """Unknown parent or child link.

    urdfdom cannot build the tree and rejects the whole robot. Names must match exactly, including case and spaces.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    links = KnownNames(link.name for link in robot.links)
    places = {link.name: link.at for link in robot.links}
    children = {child_of(joint) for joint in robot.joints}
    for joint in robot.joints:
        for kind, end in (("parent", joint.parent), ("child", joint.child)):
            if end is None or not end.name or end.name in links or not is_known(end.name):
                continue
            meant = links.meant_by(end.name)
            message = f"{kind} link '{end.name}' of {label('joint', joint.name)} is not defined"
            if meant and kind == "child" and meant not in children and _agrees(joint.name or "", end.name, meant):
                at, note = places[meant]["name"], Note(f"the joint names '{end.name}' here", end.at)
                message += f"; is link '{meant}', which has no parent joint, misspelt?"
                yield Finding(at, message, (note,), replaced(at, meant, end.name))
                continue
            used = end.at
            at, fix = where_written(used, end.name, meant, safe=links.is_sure(end.name, meant))
            notes = () if at is used else (Note("used here", used),)
            yield Finding(at, message + (f"; did you mean '{meant}'?" if meant else ""), notes, fix)


def _agrees(joint: str, written: str, link: str) -> bool:
    """Whether a joint's name matches the link that it names, but not the link that is defined."""
    stem = joint.removesuffix("_joint").removeprefix("joint_")
    return stem in written and stem not in link
