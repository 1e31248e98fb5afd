"""What a robot's motion must be like, with all tolerances; measured on 35 real robots and 109 hand-made cases."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from urdfctl.record import NamedTuple
from urdfctl.smoke.engines import Standing
from urdfctl.smoke.motions import CRUISE, Goal
from urdfctl.smoke.results import Trouble
from urdfctl.smoke.tasks import Drive, Family, Task

TIPPED = 0.35
"""The roll or pitch, in rad, from which on a robot has tipped over."""
ERROR_OF_STEP, LEAST_ERROR, DROOP = 0.25, 0.01, 1.5
"""A joint is where it should be within a quarter of its step, or 0.01 rad or m, or 1.5 times what its weight stretches
the loop's p gain by."""
SWING_OF_STEP, SPEED_OF_STEP = 0.2, 0.5
"""In the last quarter a joint oscillates that swings by more than this part of its step, and moves, in the root of the
mean square, by more than this part of it in a second."""
SWING_TOGETHER, SPEED_TOGETHER = 0.02, 0.1
"""The same for all loops together, in rad or m, and rad/s or m/s."""
MOVED = 0.5
"""The part of what a velocity commands that a joint must have done."""
FASTER = 2.0
"""By which factor the end of a velocity loop's motion may be faster than it should."""
PUSHED = 1e-4
"""How far, in rad or m, an effort must have moved it at least."""
PAST_LIMIT = 0.02
"""How far, in rad or m, a joint may be past its limit."""
PAST_VELOCITY, SLACK = 1.2, 0.01
"""By which factor a joint may pass its velocity limit, and by how much besides, in rad/s or m/s."""
MIMIC = 0.02
"""How far, in rad or m, a joint may be from what it mimics."""
FORWARD, TURN = 0.3, 0.5
"""What a mobile base is told: 0.3 m/s forward, 0.5 rad/s to the left."""
STRAIGHT = (0.85, 1.15)
SLIPPING = 0.25
"""By how much more on both sides that may be in MuJoCo, whose soft contacts let wheels slip."""
STRAIGHT_YAW = 0.15
"""How far a base may come of what it was told, and how far it may turn on the way, in rad."""
LEAST_TURN = 0.05
TURNS = {"two": (0.8, 1.2), "skid": (0.05, 1.5), "steered": (0.3, 1.5)}
"""How far it may turn of what it was told: with two wheels, with more (they slip), with steered ones (which slip a
little)."""


class Track(NamedTuple):
    """What a joint did, update by update: rad or m, rad/s or m/s."""

    positions: list[float]
    velocities: list[float]
    wanted: list[float]


def joint_troubles(task: Task, goals: Sequence[Goal], tracks: Sequence[Track], seconds: float) -> Iterator[Trouble]:
    """What is wrong with the motion of a controller's joints."""
    for index, (goal, track) in enumerate(zip(goals, tracks, strict=True)):
        if not (task.family is Family.FORWARD and task.interface == "effort"):
            yield from _limits(task, goal, track)
        if task.family is Family.VELOCITY_PID or (task.family is Family.FORWARD and task.interface == "velocity"):
            yield from _turned(task, goal, track, seconds)
        elif task.family is Family.FORWARD and task.interface == "effort":
            yield from _pushed(task, goal, track)
        else:
            yield from _arrived(task, goal, track, task.gains[index].p if task.gains else 0.0)


def _trouble(code: str, task: Task, goal: Goal, what: str, *notes: str) -> Trouble:
    message = f"controller '{task.controller}': joint '{goal.hinge.name}' {what}"
    return Trouble(code, f"joint:{goal.hinge.name}", message, task.controller, notes)


def _limits(task: Task, goal: Goal, track: Track) -> Iterator[Trouble]:
    low, high = goal.hinge.span
    least, most = min(track.positions), max(track.positions)
    if goal.hinge.type != "continuous" and (least < low - PAST_LIMIT or most > high + PAST_LIMIT):
        yield _trouble(
            "UC936", task, goal, f"leaves its limits: from {least:.3g} to {most:.3g}, not {low:g} to {high:g}"
        )
    fastest, bound = max(map(abs, track.velocities)), goal.hinge.velocity
    if task.family is not Family.POSITION_PID and bound and fastest > PAST_VELOCITY * bound + SLACK:
        yield _trouble("UC937", task, goal, f"moves at {fastest:.3g}, and its velocity limit is {bound:g}")


def _arrived(task: Task, goal: Goal, track: Track, p: float) -> Iterator[Trouble]:
    last = track.positions[-max(1, len(track.positions) // 4) :]
    swing, speed = max(last) - min(last), _mean_square(track.velocities[-len(last) :])
    by = abs(goal.by)
    if swing > SWING_OF_STEP * by and speed > SPEED_OF_STEP * by:
        yield _trouble(
            "UC933", task, goal, f"swings by {swing:.3g} where it should stand", "try a higher d gain, or a lower p"
        )
        return
    droop = DROOP * abs(goal.weight) / p if task.interface == "effort" and p > 0 else 0.0
    error = abs(track.positions[-1] - goal.end)
    if error > max(ERROR_OF_STEP * by, LEAST_ERROR, droop):
        came = track.positions[-1] - goal.start
        advice = (
            "it hardly moved: is its effort limit, or a p gain, too small?" if abs(came) < ERROR_OF_STEP * by else ""
        )
        what = f"is to move by {goal.by:+.3g}, and has moved by {came:+.3g}"
        yield _trouble("UC932", task, goal, what, *([advice] if advice else []))


def _turned(task: Task, goal: Goal, track: Track, seconds: float) -> Iterator[Trouble]:
    told = goal.by if task.family is Family.FORWARD else math.copysign(CRUISE, goal.by) * seconds
    moved = track.positions[-1] - goal.start
    last = track.velocities[-max(1, len(track.velocities) // 4) :]
    runs_away = task.family is Family.VELOCITY_PID and max(map(abs, last)) > FASTER * CRUISE
    if moved * told <= 0 or abs(moved) <= MOVED * abs(told) or runs_away:
        yield _trouble("UC935", task, goal, f"is to move by {told:+.3g}, and has moved by {moved:+.3g}")


def _pushed(task: Task, goal: Goal, track: Track) -> Iterator[Trouble]:
    moved = max((position - goal.start for position in track.positions), key=abs)
    if moved * goal.by <= 0 or abs(moved) < PUSHED:
        yield _trouble("UC935", task, goal, f"is pushed to {goal.by:+.2g}, and moves by {moved:+.3g}")


def together_troubles(tasks: Sequence[Task], goals: Sequence[Goal], tracks: Sequence[Track]) -> Iterator[Trouble]:
    """What swings when all loops run at once."""
    owners = {joint: task for task in tasks for joint in task.joints}
    for goal, track in zip(goals, tracks, strict=True):
        last = track.positions[-max(1, len(track.positions) // 4) :]
        swing, speed = max(last) - min(last), _mean_square(track.velocities[-len(last) :])
        if swing > SWING_TOGETHER and speed > SPEED_TOGETHER:
            what = f"swings by {swing:.3g} when all loops run together"
            yield _trouble("UC934", owners[goal.hinge.name], goal, what, "the joints shake each other: try lower gains")
            return


def _mean_square(values: Sequence[float]) -> float:
    return math.sqrt(sum(value * value for value in values) / len(values))


# -- mobile bases ----------------------------------------------------------------------------------------------------


class Journey(NamedTuple):
    """Where a base was and came to, how far it turned on the way, in rad, and how long that took, in s."""

    before: Standing
    after: Standing
    yaw: float
    seconds: float

    @property
    def ahead(self) -> float:
        """How far it came in the direction that it looked to at first, in m."""
        x, y = self.after.x - self.before.x, self.after.y - self.before.y
        return x * math.cos(self.before.yaw) + y * math.sin(self.before.yaw)


def forward_troubles(task: Task, journey: Journey, slipping: float = 0.0) -> Iterator[Trouble]:
    """Whether a base drives forward when told so; `slipping` is by how much more its wheels may slip."""
    told = FORWARD * journey.seconds
    low, high = STRAIGHT[0] - slipping, STRAIGHT[1] + slipping
    subject = f"controller:{task.controller}"
    if not low < journey.ahead / told < high:
        message = (
            f"told to drive {told:.2g} m forward, controller '{task.controller}' moves the robot {journey.ahead:+.3g} m"
        )
        yield Trouble("UC941", subject, message, task.controller, tuple(_why_not(journey.ahead / told)))
    elif abs(journey.yaw) > STRAIGHT_YAW + slipping:
        message = f"told to drive straight, controller '{task.controller}' turns the robot by {journey.yaw:+.2g} rad"
        yield Trouble("UC941", subject, message, task.controller)


def _why_not(ratio: float) -> Iterator[str]:
    if ratio < -0.1:  # noqa: PLR2004
        yield "the wheels turn backwards: look at the axes of their joints"
    elif ratio < 0.1:  # noqa: PLR2004
        yield "the wheels do not roll: do they touch the ground, are their axes right, is their effort enough?"
    else:
        yield f"the wheels' real radius seems to be {ratio:.2g} times the one that the controller is told"


def turn_troubles(
    task: Task, drive: Drive, journey: Journey, steering: float, slipping: float = 0.0
) -> Iterator[Trouble]:
    """Whether a base turns left when told so."""
    told = TURN * journey.seconds
    kind = "two" if len(drive.left) + len(drive.right) == 2 else "skid"  # noqa: PLR2004
    if drive.steered:
        kind = "steered"
        told = FORWARD * journey.seconds / (drive.wheelbase or 1.0) * math.tan(steering)
    low, high = TURNS[kind]
    ratio = journey.yaw / told if told else 1.0
    if max(low - slipping, LEAST_TURN) < ratio < high + slipping:
        return
    message = (
        f"told to turn left by {told:.2g} rad, controller '{task.controller}' turns the robot by {journey.yaw:+.2g} rad"
    )
    note = "the other way round: are left and right exchanged, or a steering axis upside down?" if ratio < 0 else ""
    yield Trouble("UC942", f"controller:{task.controller}", message, task.controller, (note,) if note else ())
