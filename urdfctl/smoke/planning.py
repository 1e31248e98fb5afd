"""The plan for simulating a robot, which goes to the worker of a physics engine."""

from __future__ import annotations

from urdfctl.load.meshes import mesh_path
from urdfctl.rules.smoke.collision_mesh_left_out import collision_mesh_left_out
from urdfctl.rules.smoke.engine_refuses_robot import engine_refuses_robot
from urdfctl.rules.smoke.inertia_unusable import inertia_unusable
from urdfctl.smoke.judgement import Judgement
from urdfctl.smoke.plan import MOTION, Plan
from urdfctl.smoke.prepare import Prepared, names_of_wheels, prepared
from urdfctl.smoke.results import ROBOT, Trouble, trouble_of
from urdfctl.source.packages import Packages

MOST_BODIES = 800
"""A robot with more links than this is not simulated: pybullet takes minutes for a chain of a thousand links."""


def plan_of(
    judgement: Judgement, packages: Packages, duration: float = MOTION, *, gui: bool = False
) -> tuple[Plan | None, list[Trouble]]:
    """Return the plan, or None if there is nothing to move, and what was found while making it."""
    mechanism, robot = judgement.mechanism, judgement.seen.project.robot
    unusable = any(trouble.code == inertia_unusable.code for trouble in judgement.troubles)
    if mechanism is None or robot is None or unusable:
        return None, []
    if len(mechanism.bodies) > MOST_BODIES:
        why = f"it has {len(mechanism.bodies)} links, and the limit is {MOST_BODIES}"
        return None, [trouble_of(engine_refuses_robot, ROBOT, engine="the smoke test", why=why)]
    tasks = tuple(task for task in judgement.tasks if judgement.wants(task.controller))
    drives = [task.drive for task in tasks if task.drive]
    wheels: dict[str, float] = {}
    for drive in drives:
        wheels |= names_of_wheels(mechanism, (*drive.left, *drive.right, *drive.driven, *drive.steered), drive.radius)
    damped = {joint for task in tasks if task.interface == "effort" for joint in task.joints}
    path = judgement.seen.result.path

    def find_mesh(address: str) -> str | None:
        return mesh_path(address, packages, path)

    def on_ground(*, standing: bool) -> Prepared:
        return prepared(robot, mechanism, find_mesh, wheels, standing=standing, damped=damped)

    ready = on_ground(standing=bool(drives))
    support = judgement.support
    plan = Plan(
        engine="",
        urdf=ready.urdf,
        mechanism=mechanism,
        tasks=tasks,
        rate=judgement.rate,
        fixed=not drives,
        shapeless=bool(ready.left_out),
        duration=duration,
        gui=gui,
        standing=on_ground(standing=True).urdf if support.links and not support.why_not else "",
        held=support.why_not,
        assignments=tuple(each for each in judgement.given.assignments if judgement.wants(each.controller))
        if judgement.given
        else (),
    )
    return plan, _left_out(ready) if drives else _left_out(ready._replace(left_out=ready.broken))


def _left_out(ready: Prepared) -> list[Trouble]:
    if not ready.left_out:
        return []
    (link, why), *others = ready.left_out.items()
    links = f"{len(others)} other link{'s' if len(others) > 1 else ''}"
    more = f", and that of {links}" if others else ""
    return [trouble_of(collision_mesh_left_out, f"link:{link}", link=link, more=more, why=why)]
