"""The bases that no engine can drive here, because what moves them is not what their controllers name."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from urdfctl.catalog.distros import generation
from urdfctl.control.hardware.gazebo_ros1 import has_own_simulation
from urdfctl.model.project import Project
from urdfctl.model.robot import Robot
from urdfctl.smoke.robot import LATERAL, Mechanism, ties_of, wheels_of
from urdfctl.smoke.tasks import ControllerTask, Drive, MotionFamily

TIED = "{} of <gazebo> ties links in a way that is not modelled, so that the robot does not stand here"
VIRTUAL = "the robot's own simulation class moves it, and its controller names wheels that do not roll"
ABSENT = "its wheel '{}' is not a movable joint of the robot"
SMALLER = 0.5
"""A wheel of this fraction of the radius that its controller uses is no wheel: it stands for others."""


def tied_by(robot: Robot) -> str:
    """Return why a robot cannot be put on the ground, if `<gazebo>` adds joints to it; else an empty text."""
    ties = ties_of(robot)
    if not ties:
        return ""
    more = f" and {len(ties) - 1} more" if len(ties) > 1 else ""
    return TIED.format(f"joint '{ties[0]}'{more}")


def with_virtual_wheels(
    project: Project, distro: str, mechanism: Mechanism, tasks: Sequence[ControllerTask]
) -> tuple[ControllerTask, ...]:
    """Return the tasks of a robot. A base whose wheels stand for others is not driven.

    A simulation class of the robot's own packages may move real wheels as a controller commands virtual ones.
    """
    if generation(distro) != 1 or not has_own_simulation(project):
        return tuple(tasks)
    return tuple(
        undriven([task], VIRTUAL)[0] if task.base and _is_virtual(mechanism, task.base) else task for task in tasks
    )


def _is_virtual(mechanism: Mechanism, drive: Drive) -> bool:
    return any(
        abs(wheel.axis[1]) < LATERAL or (mechanism.bodies[wheel.hinge.child].radius or 0.0) < SMALLER * drive.radius
        for wheel in wheels_of(mechanism, drive.wheels, drive.base)
    )


def with_own_wheels(mechanism: Mechanism, tasks: Iterable[ControllerTask]) -> tuple[ControllerTask, ...]:
    """Return the tasks of a robot. A base is not driven with wheels that the robot lacks: a driver may offer them."""
    known = {hinge.name for hinge in mechanism.hinges if hinge.moves}
    absent = ((task, next((name for name in _joints_of(task) if name not in known), None)) for task in tasks)
    return tuple(undriven([task], ABSENT.format(name))[0] if name else task for task, name in absent)


def _joints_of(task: ControllerTask) -> tuple[str, ...]:
    return (*task.base.wheels, *task.base.steered) if task.base else ()


def undriven(tasks: Iterable[ControllerTask], why: str) -> tuple[ControllerTask, ...]:
    """Return tasks, of which those of a base are not simulated, with the reason."""
    return tuple(
        ControllerTask(task.controller, MotionFamily.STRUCTURAL, why=why) if task.base else task for task in tasks
    )
