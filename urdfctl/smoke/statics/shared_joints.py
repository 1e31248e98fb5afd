"""Controllers of which each commands only some of the joints of the other: they are no alternatives, and clash."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from urdfctl.rules.smoke.controllers_share_a_joint import controllers_share_a_joint
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.tasks import ControllerTask


def shared_joint_troubles(tasks: Sequence[ControllerTask]) -> Iterator[Trouble]:
    """Yield the pairs of controllers that command a joint in common, and each joints of its own.

    Controllers of the same joints, or of some of them, are often alternatives, of which one is started.
    """
    owners = [task for task in tasks if len(task.joints) > 1 and not task.through]
    for one, other in combinations(owners, 2):
        mine, yours = set(one.joints), set(other.joints)
        common = [joint for joint in one.joints if joint in yours]
        if common and mine - yours and yours - mine and one.interface == other.interface:
            fields = {"other": one.controller, "joint": common[0]}
            yield trouble_of(
                controllers_share_a_joint, f"controller:{other.controller}", other.controller, (), **fields
            )
