"""What an engine's worker is told of a robot that may be moved."""

from __future__ import annotations

from urdfctl.meshes import mesh_path
from urdfctl.smoke.judgement import Judgement
from urdfctl.smoke.prepare import Prepared, names_of_wheels, prepared
from urdfctl.smoke.results import Trouble
from urdfctl.smoke.trial import MOTION, Plan
from urdfctl.source.packages import Packages

MOST_BODIES = 800
"""More links no engine is given: pybullet takes minutes for a chain of a thousand."""


def plan_of(
    judgement: Judgement, packages: Packages, duration: float = MOTION, *, gui: bool = False
) -> tuple[Plan | None, list[Trouble]]:
    """The plan, None where there is nothing to be moved, and what was found on the way."""
    mechanism, robot = judgement.mechanism, judgement.seen.project.robot
    unusable = any(one.code == "UC910" for one in judgement.troubles)
    if mechanism is None or robot is None or unusable:
        return None, []
    if len(mechanism.bodies) > MOST_BODIES:
        message = f"the robot has {len(mechanism.bodies)} links, and is moved only with up to {MOST_BODIES}"
        return None, [Trouble("UC921", "robot", message)]
    tasks = tuple(task for task in judgement.tasks if judgement.wants(task.controller))
    drives = [task.drive for task in tasks if task.drive]
    wheels: dict[str, float] = {}
    for drive in drives:
        wheels |= names_of_wheels(mechanism, (*drive.left, *drive.right, *drive.driven, *drive.steered), drive.radius)
    damped = {joint for task in tasks if task.interface == "effort" for joint in task.joints}
    path = judgement.seen.linted.path
    made = prepared(
        robot,
        mechanism,
        lambda address: mesh_path(address, packages, path),
        wheels,
        standing=bool(drives),
        damped=damped,
    )
    plan = Plan("", made.urdf, mechanism, tasks, judgement.rate, not drives, bool(made.left_out), duration, gui)
    return plan, _left_out(made) if drives else _left_out(made._replace(left_out=made.broken))


def _left_out(made: Prepared) -> list[Trouble]:
    if not made.left_out:
        return []
    (link, why), *others = made.left_out.items()
    more = f", and those of {len(others)} more links" if others else ""
    message = f"the collision mesh of link '{link}' is left out{more}: {why}"
    return [Trouble("UC922", f"link:{link}", message)]
