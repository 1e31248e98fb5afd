"""The physics that needs no engine: masses, limits and mimic joints; with the wheels, the ground and the efforts."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence

from urdfctl.model.robot import Robot
from urdfctl.rules.smoke.command_range_too_small import command_range_too_small
from urdfctl.rules.smoke.inertia_too_large import inertia_too_large
from urdfctl.rules.smoke.inertia_too_small import inertia_too_small
from urdfctl.rules.smoke.inertia_unusable import inertia_unusable
from urdfctl.rules.smoke.initial_position_beyond_limits import initial_position_beyond_limits
from urdfctl.rules.smoke.joint_held_still import joint_held_still
from urdfctl.rules.smoke.joint_too_slow import joint_too_slow
from urdfctl.rules.smoke.joint_without_range import joint_without_range
from urdfctl.rules.smoke.mimic_beyond_limits import mimic_beyond_limits
from urdfctl.rules.urdf.inertia_out_of_proportion import size_of
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Hinge, Mechanism, Shapes, moved_inertias
from urdfctl.smoke.statics.drives import drive_troubles
from urdfctl.smoke.statics.efforts import effort_troubles
from urdfctl.smoke.statics.fingers import finger_troubles
from urdfctl.smoke.statics.ground import ground_troubles
from urdfctl.smoke.tasks import ControllerTask

LEAST_REACH = 1 / 30
"""The radius of gyration of a link should be at least this fraction of its largest dimension."""
MOST_REACH = 5.0
"""The radius of gyration of a link is at most this multiple of its largest dimension."""
EASY = 10.0
"""A motor that accelerates its joint by more is strong enough, whatever the inertia is, in rad/s² or m/s²."""
LEAST_MASS = 0.01
"""Lighter links are not judged by their inertia, in kg."""
DENSEST = 22_600.0
"""The density of osmium, in kg/m³: shapes that would be denser than this stand for a link that is larger."""
LEAST_RANGE = 0.01
"""The range of a command should be at least this fraction of the joint's own range."""
MOST_SECONDS = 120.0
"""A joint should cross its range, or turn around, in this time, in s."""
BEYOND = 0.02
"""A mimic joint may be asked to exceed its limits by this fraction of its range."""


def static_troubles(
    mechanism: Mechanism, tasks: Sequence[ControllerTask], robot: Robot, shapes: Shapes, held: Collection[str] = ()
) -> Iterator[Trouble]:
    """Yield what is wrong with a robot at rest, and with what its active controllers should move.

    held: the joints with a velocity limit of 0 in hardware that may obey it.
    """
    unusable = list(_masses(mechanism))
    yield from unusable
    limited = mechanism.within_command_ranges()
    yield from drive_troubles(limited, tasks)
    for task in tasks:
        if not task.through:  # the controllers that it commands are checked
            yield from _limits(mechanism, task, held)
    yield from _mimics(mechanism)
    yield from finger_troubles(mechanism)
    yield from _starts(mechanism)
    if not unusable:
        yield from effort_troubles(limited, tasks)
        yield from _inertias(mechanism, tasks, robot)
        yield from ground_troubles(mechanism, shapes, tasks)


def _masses(mechanism: Mechanism) -> Iterator[Trouble]:
    for body in mechanism.bodies.values():
        numbers = (body.mass, *body.centre, *(moment for row in body.inertia for moment in row))
        problem = ""
        if not all(map(math.isfinite, numbers)):
            problem = "not a finite number"
        elif body.mass < 0 or any(body.inertia[n][n] < 0 for n in range(3)):
            problem = "negative"
        if problem:
            yield trouble_of(inertia_unusable, f"link:{body.name}", link=body.name, problem=problem)


def _inertias(mechanism: Mechanism, tasks: Sequence[ControllerTask], robot: Robot) -> Iterator[Trouble]:
    """The links whose inertia decides how they move: too little matters to efforts, far too much to weak motors and to
    gains."""
    moved = _moved(mechanism, {joint: task.controller for task in tasks for joint in task.joints})
    pushed = _moved(mechanism, {joint: "" for task in tasks if task.interface == "effort" for joint in task.joints})
    for link in robot.links:
        body = mechanism.bodies.get(link.name or "")
        if body is None or body.name not in moved or body.mass < LEAST_MASS:
            continue
        size = size_of(link)
        most = max(body.inertia[n][n] for n in range(3))
        reach = math.sqrt(most / body.mass)
        if not size or reach <= 0 or LEAST_REACH * size <= reach <= MOST_REACH * size:
            continue
        times = (size / math.sqrt(12) / reach) ** 2
        fields = {"link": body.name, "mass": f"{body.mass:g}", "size": f"{size:g}"}
        if times > 1 and body.name in pushed:
            yield trouble_of(inertia_too_small, f"link:{body.name}", None, (), **fields, times=f"{times:.1g}")
        elif times < 1 and body.mass < DENSEST * size**3 and not _is_strong(mechanism, tasks, body.name):
            owner = moved[body.name]
            yield trouble_of(inertia_too_large, f"link:{body.name}", owner, (), **fields, times=f"{1 / times:.1g}")


def _is_strong(mechanism: Mechanism, tasks: Sequence[ControllerTask], link: str) -> bool:
    """Whether no gains move a link, and the motors of all joints before it accelerate what they move easily."""
    inertias = moved_inertias(mechanism)
    owners = {joint: task for task in tasks for joint in task.joints}
    hinges = [hinge for hinge in mechanism.above(link) if hinge.name in owners]
    if any(gains.p or gains.d for hinge in hinges for gains in owners[hinge.name].gains):
        return False
    return all((hinge.effort or 0.0) > EASY * inertias.get(hinge.name, math.inf) for hinge in hinges)


def _moved(mechanism: Mechanism, owners: Mapping[str, str]) -> dict[str, str]:
    """The links that some joints move, each with what owns the nearest of them."""
    moved: dict[str, str] = {}
    for hinge in mechanism.hinges:
        owner = owners.get(hinge.name, moved.get(hinge.parent))
        if owner is not None:
            moved[hinge.child] = owner
    return moved


# -- joints ----------------------------------------------------------------------------------------------------------


def _limits(mechanism: Mechanism, task: ControllerTask, held: Collection[str]) -> Iterator[Trouble]:
    for hinge in filter(None, map(mechanism.hinge, task.joints)):
        if hinge.name in held and hinge.moves:
            yield trouble_of(joint_held_still, f"joint:{hinge.name}", task.controller, joint=hinge.name)
        elif hinge.moves and hinge.span[0] == hinge.span[1]:
            limits = {"lower": hinge.lower, "upper": hinge.upper}
            yield trouble_of(
                joint_without_range, f"joint:{hinge.name}", task.controller, (), joint=hinge.name, **limits
            )
        elif hinge.moves:
            yield from _ranges(hinge, task)
            yield from _slow(hinge, task)


def _ranges(hinge: Hinge, task: ControllerTask) -> Iterator[Trouble]:
    """The range of commands that the hardware allows, against the range that the joint has."""
    low, high = hinge.range_of(task.interface)
    if low == -math.inf:
        return
    whole = {"position": hinge.span, "velocity": _both(hinge.velocity), "effort": _both(hinge.effort)}.get(
        task.interface
    )
    if whole is None or not whole[1] > whole[0]:
        return
    common = min(high, whole[1]) - max(low, whole[0])
    if common < LEAST_RANGE * (whole[1] - whole[0]):
        fields = {"joint": hinge.name, "interface": task.interface, "low": low, "high": high}
        given = {"least": whole[0], "most": whole[1]}
        yield trouble_of(command_range_too_small, f"joint:{hinge.name}", task.controller, (), **fields, **given)


def _slow(hinge: Hinge, task: ControllerTask) -> Iterator[Trouble]:
    """The velocity limit against the range of a joint, or against a whole turn."""
    low, high = hinge.span
    way = 2 * math.pi if hinge.type == "continuous" else min(high - low, 2 * math.pi)
    if not hinge.velocity or hinge.name in task.driven_joints or way / hinge.velocity <= MOST_SECONDS:
        return
    fields = {"joint": hinge.name, "limit": f"{hinge.velocity:g}", "unit": hinge.unit}
    seconds = f"{way / hinge.velocity:.0f}"
    yield trouble_of(joint_too_slow, f"joint:{hinge.name}", task.controller, (), **fields, seconds=seconds)


def _both(limit: float | None) -> tuple[float, float] | None:
    return (-limit, limit) if limit else None


def _starts(mechanism: Mechanism) -> Iterator[Trouble]:
    for hinge in mechanism.hinges:
        low, high = hinge.span
        slack = BEYOND * (high - low)
        given = hinge.initial
        if given is None or not hinge.moves or hinge.type == "continuous" or low - slack <= given <= high + slack:
            continue
        fields = {"joint": hinge.name, "start": given, "unit": hinge.unit, "lower": low, "upper": high}
        yield trouble_of(initial_position_beyond_limits, f"joint:{hinge.name}", None, (), **fields)


def _mimics(mechanism: Mechanism) -> Iterator[Trouble]:
    for hinge in mechanism.hinges:
        leader = mechanism.hinge(hinge.mimic[0]) if hinge.mimic else None
        if leader is None or not hinge.mimic or not hinge.moves or "continuous" in (leader.type, hinge.type):
            continue
        _, factor, offset = hinge.mimic
        ends = sorted(factor * end + offset for end in leader.span)
        low, high = hinge.span
        slack = BEYOND * (high - low)
        if ends[0] < low - slack or ends[1] > high + slack:
            fields = {"joint": hinge.name, "leader": leader.name, "unit": hinge.unit}
            asked = {"least": ends[0], "most": ends[1], "lower": low, "upper": high}
            yield trouble_of(mimic_beyond_limits, f"joint:{hinge.name}", None, (), **fields, **asked)
