"""The check of a file of tasks against a robot: its controllers, their joints, and the limits of these."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from urdfctl.names import did_you_mean
from urdfctl.smoke.robot import Hinge, Mechanism
from urdfctl.smoke.tasks.task import ControllerTask, MotionFamily
from urdfctl.smoke.tasks.task_file import TaskFile, UserTask
from urdfctl.startup.records import NamedTuple


class Misfit(NamedTuple):
    """A task that does not fit a robot, with its line in the file. `absent`: another robot may have what it names."""

    line: int
    message: str
    absent: bool = False


def misfits(
    file: TaskFile, mechanism: Mechanism, tasks: Sequence[ControllerTask], names: Collection[str]
) -> Iterator[Misfit]:
    """Yield what does not fit a robot with some tasks; `names` holds all its controllers, with those that fail."""
    for name, value, line in file.start:
        hinge = mechanism.hinge(name)
        if hinge is None:
            yield Misfit(line, f"no robot has a joint '{name}'{did_you_mean(name, mechanism.start())}", absent=True)
        elif not hinge.moves or hinge.mimic:
            yield Misfit(line, f"joint '{name}' does not move by itself")
        else:
            yield from _beyond(hinge, value, hinge.span, line)
    by_name = {task.controller: task for task in tasks}
    for user_task in file.user_tasks:
        task = by_name.get(user_task.controller)
        if task is not None:
            yield from _of_task(user_task, task, mechanism)
        elif user_task.controller not in names:
            line = file.line_of(user_task)
            hint = did_you_mean(user_task.controller, names)
            yield Misfit(line, f"no robot has a controller '{user_task.controller}'{hint}", absent=True)


def kinds_of(task: ControllerTask) -> tuple[str, ...]:
    """Return the kinds of tasks that a controller can perform in an engine."""
    if task.drive and not task.drive.is_inferred:
        return ("drive",)
    held = task.family in (MotionFamily.POSITION_PID, MotionFamily.TRAJECTORY)
    if held or (task.family is MotionFamily.FORWARD and task.interface == "position"):
        return "target", "trajectory"
    turned = task.family is MotionFamily.VELOCITY_PID or (
        task.family is MotionFamily.FORWARD and task.interface == "velocity"
    )
    return ("velocity",) if turned else ()


def _of_task(user_task: UserTask, task: ControllerTask, mechanism: Mechanism) -> Iterator[Misfit]:
    kinds, first = kinds_of(task), user_task.steps[0].line
    if user_task.kind not in kinds:
        why = f"use {' or '.join(kinds)}" if kinds else task.why or f"it {task.family.value}"
        yield Misfit(first, f"controller '{task.controller}' cannot perform a {user_task.kind}: {why}")
        return
    for step in user_task.steps if user_task.kind != "drive" else ():
        for name, value in step.values:
            hinge = mechanism.hinge(name)
            if name not in task.joints or hinge is None:
                hint = did_you_mean(name, task.joints)
                yield Misfit(step.line, f"controller '{task.controller}' does not command joint '{name}'{hint}")
            elif user_task.kind == "velocity":
                most = hinge.velocity or abs(value)
                yield from _beyond(hinge, value, (-most, most), step.line, per_second=True)
            else:
                yield from _beyond(hinge, value, hinge.span, step.line)


def _beyond(
    hinge: Hinge, value: float, span: tuple[float, float], line: int, *, per_second: bool = False
) -> Iterator[Misfit]:
    unit = f"{hinge.unit}/s" if per_second else hinge.unit
    low, high = span
    if (hinge.type != "continuous" or per_second) and not low <= value <= high:
        yield Misfit(
            line, f"{value:g} {unit} is outside the limits of joint '{hinge.name}', {low:g} to {high:g} {unit}"
        )
