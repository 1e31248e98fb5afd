"""Whether a file of tasks fits a robot: its controllers, their joints, and the limits of these."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from urdfctl.names import did_you_mean
from urdfctl.smoke.assignments import Assignment, TaskFile
from urdfctl.smoke.mechanism import Hinge, Mechanism
from urdfctl.smoke.tasks import Family, Task
from urdfctl.startup.records import NamedTuple


class Misfit(NamedTuple):
    """A task that does not fit a robot, with its line in the file. `absent`: another robot may have what it names."""

    line: int
    message: str
    absent: bool = False


def misfits(file: TaskFile, mechanism: Mechanism, tasks: Sequence[Task], names: Collection[str]) -> Iterator[Misfit]:
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
    for assignment in file.assignments:
        task = by_name.get(assignment.controller)
        if task is not None:
            yield from _of_task(assignment, task, mechanism)
        elif assignment.controller not in names:
            line = file.line_of(assignment)
            hint = did_you_mean(assignment.controller, names)
            yield Misfit(line, f"no robot has a controller '{assignment.controller}'{hint}", absent=True)


def kinds_of(task: Task) -> tuple[str, ...]:
    """Return the kinds of tasks that a controller can perform in an engine."""
    if task.drive and not task.drive.plain:
        return ("drive",)
    held = task.family in (Family.POSITION_PID, Family.TRAJECTORY)
    if held or (task.family is Family.FORWARD and task.interface == "position"):
        return "target", "trajectory"
    turned = task.family is Family.VELOCITY_PID or (task.family is Family.FORWARD and task.interface == "velocity")
    return ("velocity",) if turned else ()


def _of_task(assignment: Assignment, task: Task, mechanism: Mechanism) -> Iterator[Misfit]:
    kinds, first = kinds_of(task), assignment.steps[0].line
    if assignment.kind not in kinds:
        why = f"use {' or '.join(kinds)}" if kinds else task.why or f"it {task.family.value}"
        yield Misfit(first, f"controller '{task.controller}' cannot perform a {assignment.kind}: {why}")
        return
    for step in assignment.steps if assignment.kind != "drive" else ():
        for name, value in step.values:
            hinge = mechanism.hinge(name)
            if name not in task.joints or hinge is None:
                hint = did_you_mean(name, task.joints)
                yield Misfit(step.line, f"controller '{task.controller}' does not command joint '{name}'{hint}")
            elif assignment.kind == "velocity":
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
