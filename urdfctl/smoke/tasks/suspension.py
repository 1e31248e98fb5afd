"""Joints that let the wheels of a base follow the ground, as the rockers of a rover do."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.smoke.robot import Mechanism
from urdfctl.smoke.tasks.task import ControllerTask, MotionFamily


def suspended_wheels(mechanism: Mechanism, tasks: Sequence[ControllerTask]) -> dict[str, frozenset[str]]:
    """Return the driven wheels that joints let move up and down, each with these joints.

    A joint between the base and a wheel does so if controllers only forward efforts to it: without a command they
    forward none, and it is free.
    """
    pushing = [task for task in tasks if task.family is MotionFamily.FORWARD and task.interface == "effort"]
    moved = {joint for task in tasks if task not in pushing for joint in task.joints}
    free = {joint for task in pushing for joint in task.joints} - moved
    found = {}
    for wheel in (mechanism.hinge(joint) for task in tasks for joint in task.driven_joints):
        above = mechanism.above(wheel.parent) if wheel else []
        joints = frozenset(hinge.name for hinge in above if hinge.name in free)
        if wheel and joints:
            found[wheel.name] = joints
    return found
