"""UC673."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.moveit.common import is_of_other_robot, planning
from urdfctl.rules.moveit.samples import planned

_VIRTUAL = '<virtual_joint name="to_world" type="planar" parent_frame="map" child_link="{}"/>\n      <group name="arm">'


@rule(
    "UC673",
    severity=Severity.WARNING,
    runtime="ignores",
    whole_robot=True,
    in_library=False,
    authority="moveit_core robot_model.cpp constructJointModel(): \"Skipping virtual joint 'to_world' because its child frame "
    "'base' does not match the URDF frame 'world'\"",
    bad=[planned('<group name="arm">', _VIRTUAL.format("«base»"))],
    good=[planned('<group name="arm">', _VIRTUAL.format("world"))],
)
def virtual_joint_not_at_root(project: Project) -> Iterator[Finding]:
    """Virtual joint is not attached to the root link.

    MoveIt ignores it, and fixes the root link to the world. A mobile base then does not move in the planning scene.
    Only a fixed joint below an empty root link `world` is accepted.
    """
    groups = planning(project)
    if groups is None or groups.root is None or is_of_other_robot(project):
        return
    for virtual in groups.semantic.virtual:
        child = virtual.child
        if child is not None and child.text in groups.links and not groups.is_at_root(virtual):
            name = virtual.name.text if virtual.name else ""
            message = (
                f"MoveIt skips virtual joint '{name}': its child '{child.text}' is not the root link '{groups.root}'"
            )
            yield Finding(child.at, message, (), replaced(child.at, child.text, groups.root))
