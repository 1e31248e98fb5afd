"""Controllers whose joints move at the same time, because no motion of one is felt by another."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.smoke.robot import Mechanism
from urdfctl.smoke.tasks import ControllerTask, MotionFamily

_ALONE = (MotionFamily.NOTHING, MotionFamily.STRUCTURAL)


def groups_of(tasks: Sequence[ControllerTask], mechanism: Mechanism, *, fixed: bool) -> list[list[ControllerTask]]:
    """Return the controllers in groups that can be tested together, in the order of the first of each.

    Joints of different branches do not disturb each other if the base is fixed, and motors that follow a position or a
    velocity hardly do in one branch. The controllers of a group command in the same way, so that one motion takes the
    same time for all.
    """
    groups: list[tuple[tuple[MotionFamily, str], set[str], list[ControllerTask]]] = []
    for task in tasks:
        links = _driven(task, mechanism) if is_motor(task) else _moved(task, mechanism)
        kind = task.family, task.interface
        together = fixed and bool(links) and not _alone(task)
        for of_group, taken, members in groups if together else ():
            if of_group == kind and not taken & links and not _alone(members[0]):
                taken.update(links)
                members.append(task)
                break
        else:
            groups.append((kind, set(links), [task]))
    return [members for _, _, members in groups]


def _alone(task: ControllerTask) -> bool:
    """Whether a controller is tested alone: it moves nothing, drives a base, or pushes one joint after the other."""
    pushes = task.family is MotionFamily.FORWARD and task.interface == "effort"
    return task.base is not None or pushes or task.family in _ALONE


def is_motor(task: ControllerTask) -> bool:
    """Return whether the hardware follows the commands of a controller: no loop of it answers to disturbances."""
    return task.family in (MotionFamily.FORWARD, MotionFamily.TRAJECTORY) and task.interface in ("position", "velocity")


def _driven(task: ControllerTask, mechanism: Mechanism) -> set[str]:
    """The links whose joints a controller moves, with those of the joints that mimic them."""
    names = set(task.joints)
    return {h.child for h in mechanism.hinges if h.name in names or (h.mimic and h.mimic[0] in names)}


def _moved(task: ControllerTask, mechanism: Mechanism) -> set[str]:
    """All links that a controller moves, with those that hang on the joints that mimic its joints."""
    names = set(task.joints)
    moved: set[str] = set()
    for hinge in mechanism.hinges:
        if hinge.name in names or (hinge.mimic and hinge.mimic[0] in names):
            moved |= mechanism.below(hinge.child)
    return moved
