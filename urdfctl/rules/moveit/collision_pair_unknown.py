"""UC662."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.moveit.common import is_of_other_robot, planning
from urdfctl.rules.moveit.samples import planned


@rule(
    "UC662",
    severity=Severity.WARNING,
    runtime="ignores",
    whole_robot=True,
    in_library=False,
    authority="srdfdom src/model.cpp loadCollisionPairs(): \"Link 'uper' is not known to URDF. Cannot disable/enable collisons.\"",
    bad=[planned('link2="upper"', 'link2="«uper»"')],
    good=[planned()],
)
def collision_pair_unknown(project: Project) -> Iterator[Finding]:
    """<disable_collisions> names an unknown link.

    MoveIt ignores the pair. If the link was renamed, MoveIt now sees a collision where two links touch, and finds no
    plan.
    """
    groups = planning(project)
    if groups is None or is_of_other_robot(project):
        return
    counts: dict[str, int] = {}
    unknown = [
        key for pair in groups.semantic.pairs for key in pair if key.text not in groups.links and is_known(key.text)
    ]
    for key in unknown:
        counts[key.text] = counts.get(key.text, 0) + 1
    for key in unknown:
        pairs = counts.pop(key.text, 0)
        if pairs:
            meant = nearest(key.text, groups.links)
            hint = f"; did you mean '{meant}'?" if meant else ""
            more = f" ({pairs} pairs)" if pairs > 1 else ""
            message = f"<disable_collisions> names link '{key.text}', which the robot does not have{more}{hint}"
            yield Finding(key.at, message, severity=None if meant else Severity.INFO)
