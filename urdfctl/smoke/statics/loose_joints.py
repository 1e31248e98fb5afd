"""Joints that nothing commands or holds, and that fall under the weight of what hangs on them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from urdfctl.model.robot import Robot, Tag
from urdfctl.rules.smoke.joint_hangs_loose import joint_hangs_loose
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import GRAVITY, Hinge, Mechanism, worst_loads
from urdfctl.smoke.tasks import ControllerTask

LEAST_WEIGHT = 0.05
"""A joint is loose only if more than this pulls at it, in N m or N."""
LEAST_LEVER = 0.01
"""A joint is loose only if its load is this far from its axis, in m: wheels and casters turn about their middle."""


def loose_troubles(
    mechanism: Mechanism, tasks: Sequence[ControllerTask], robot: Robot, *, falls: bool
) -> Iterator[Trouble]:
    """Yield the joints that hang loose in a chain of commanded joints.

    falls: whether a simulator with gravity certainly runs the robot: a loose joint at the end of a chain is told then.
    """
    commanded = {joint for task in tasks if not task.base for joint in task.joints}
    if not commanded:
        return
    held = held_joints(robot) | {joint for task in tasks for joint in task.joints}
    loose = [hinge for hinge in mechanism.hinges if hinge.moves and not hinge.mimic and hinge.name not in held]
    chained = [hinge for hinge in loose if _is_chained(mechanism, hinge, commanded, falls=falls)]
    for name, (weight, _) in worst_loads(mechanism, chained).items():
        hinge = next(hinge for hinge in chained if hinge.name == name)
        mass = sum(mechanism.bodies[link].mass for link in mechanism.below(hinge.child))
        lever = weight / (-GRAVITY[2] * mass) if mass else 0.0
        if weight > max(LEAST_WEIGHT, hinge.friction) and lever > LEAST_LEVER:
            fields = {"joint": name, "link": hinge.child, "weight": weight, "unit": hinge.effort_unit}
            yield trouble_of(joint_hangs_loose, f"joint:{name}", None, (), **fields)


def held_joints(robot: Robot) -> set[str]:
    """Return the joints that hardware, a transmission or a plugin of a simulator moves or holds."""
    parts = [part for whole in robot.ros2_controls for part in whole.parts]
    hardware = {part.name for part in parts if part.name and any(i.kind == "command" for i in part.interfaces)}
    driven = {joint.name for transmission in robot.transmissions for joint in transmission.joints if joint.name}
    sprung = {gazebo.reference for gazebo in robot.gazebos if gazebo.reference and _is_sprung(gazebo.tag)}
    texts = {text for gazebo in robot.gazebos for plugin in gazebo.plugins for text in _texts(plugin.tag)}
    return hardware | driven | sprung | texts


def _is_sprung(gazebo: Tag) -> bool:
    names = {"springStiffness", "springReference", "spring_stiffness", "implicitSpringDamper"}
    return any(child.name in names for child in gazebo.children)


def _texts(tag: Tag) -> Iterator[str]:
    """The words in a plugin's settings: names of joints are among them."""
    yield from tag.text.split()
    for child in tag.children:
        yield from _texts(child)


def _is_chained(mechanism: Mechanism, hinge: Hinge, commanded: set[str], *, falls: bool) -> bool:
    """Whether a joint is between commanded ones, or is an uncommanded motor at the end of a chain of them."""
    below = mechanism.below(hinge.child)
    if any(each.name in commanded for each in mechanism.hinges if each.parent in below):
        return True
    above = [each for each in mechanism.above(hinge.parent) if each.name in commanded]
    has_motor = hinge.type != "continuous" and bool(hinge.effort) and math.isfinite(hinge.effort or 0.0)
    return falls and bool(above) and has_motor and not hinge.damping
