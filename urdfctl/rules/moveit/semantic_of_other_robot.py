"""UC657."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.moveit.common import is_of_other_robot, planning
from urdfctl.rules.moveit.samples import planned


@rule(
    "UC657",
    severity=Severity.WARNING,
    runtime="warns",
    in_library=False,
    authority="srdfdom src/model.cpp initXml(): 'Semantic description is not specified for the same robot as the URDF'",
    bad=[planned('<robot name="arm">', '<robot name="«old_arm»">')],
    good=[planned()],
)
def semantic_of_other_robot(project: Project) -> Iterator[Finding]:
    """SRDF is for another robot than the URDF.

    MoveIt compares the names of the two <robot> elements. It reports an error if they differ, and goes on. If the links
    and joints differ too, MoveIt ignores them, and the planning groups are empty.
    """
    groups = planning(project)
    if groups is None or project.robot is None or groups.semantic.name is None:
        return
    name, wanted = groups.semantic.name, project.robot.name
    if not is_of_other_robot(project) and (wanted is None or name.text == wanted):
        return
    notes = (Note("the robot is named here", project.robot.at["name"]),)
    if is_of_other_robot(project):
        message = f"this SRDF is for another robot: '{wanted}' has few of the links and joints that it names"
        yield Finding(name.at, message, notes, severity=Severity.ERROR)
    else:
        fix = replaced(name.at, name.text, wanted) if wanted else None
        yield Finding(name.at, f"the SRDF is for robot '{name.text}', but the URDF describes '{wanted}'", notes, fix)
