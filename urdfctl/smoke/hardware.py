"""What the hardware does between a controller and its joints: ranges of commands, and transmissions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from urdfctl.model.parts import Text
from urdfctl.model.robot import Robot
from urdfctl.model.ros2_control import ControlTransmission
from urdfctl.model.transmission import Transmission
from urdfctl.smoke.mechanism import Hinge, Mechanism
from urdfctl.smoke.tasks import Task


def within_ranges(mechanism: Mechanism) -> Mechanism:
    """Return a mechanism whose limits of velocity and effort are those that `<ros2_control>` allows to command."""
    return mechanism._replace(hinges=tuple(map(_limited, mechanism.hinges)))


def _limited(hinge: Hinge) -> Hinge:
    velocity, effort = (
        _least(own, _greatest(hinge, name)) for own, name in ((hinge.velocity, "velocity"), (hinge.effort, "effort"))
    )
    return hinge._replace(velocity=velocity, effort=effort)


def _greatest(hinge: Hinge, interface: str) -> float:
    """The greatest command to an interface in either direction; infinite if there is no range."""
    return max(map(abs, hinge.range_of(interface)))


def _least(limit: float | None, most: float) -> float | None:
    """A limit that is not greater than the greatest command; a limit of 0 means something else and is kept."""
    if not math.isfinite(most) or most <= 0 or limit == 0:
        return limit
    return most if limit is None else min(limit, most)


def with_transmissions(robot: Robot, tasks: Sequence[Task]) -> tuple[Task, ...]:
    """Return the tasks, in which the reductions and offsets of transmissions count as not simulated.

    They act between motor and joint (transmission_interface/simple_transmission.hpp): commands, states and limits of a
    joint are the same with any reduction, and nothing tells how a motor is mounted.
    """
    geared = dict(_geared(robot))

    def added(task: Task) -> Task:
        name = next((joint for joint in task.joints if joint in geared), "")
        what = (("transmission", f"{geared[name]} of joint '{name}' acts in the hardware"),) if name else ()
        return task._replace(left_out=(*task.left_out, *what))

    return tuple(map(added, tasks))


def _geared(robot: Robot) -> Iterator[tuple[str, str]]:
    """The joints with a reduction other than 1 or an offset other than 0, each with that."""
    of_controls = (transmission for control in robot.ros2_controls for transmission in control.transmissions)
    everyone: list[Transmission | ControlTransmission] = [*robot.transmissions, *of_controls]
    for transmission in everyone:
        ends = (*transmission.joints, *transmission.actuators)
        reductions = [value for end in ends for text in end.reductions[:1] if (value := _number(text, 1.0)) != 1]
        offsets = [value for end in ends for text in end.offsets[:1] if (value := _number(text, 0.0)) != 0]
        what = (
            f"the reduction of {reductions[0]:g}" if reductions else f"the offset of {offsets[0]:g}" if offsets else ""
        )
        yield from ((joint.name, what) for joint in transmission.joints if joint.name and what)


def _number(text: Text, default: float) -> float:
    try:
        return float(text.value)
    except ValueError:
        return default
