"""The checks of a robot's motion, with all tolerances; measured on 35 real robots and 109 hand-made cases."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from urdfctl.fault import FaultWithMessage
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_leaves_limits import joint_leaves_limits
from urdfctl.rules.smoke.joint_moves_wrong_way import joint_moves_wrong_way
from urdfctl.rules.smoke.joint_oscillates import joint_oscillates
from urdfctl.rules.smoke.joint_too_fast import joint_too_fast
from urdfctl.rules.smoke.joints_oscillate_together import joints_oscillate_together
from urdfctl.smoke.engines import BasePose
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Hinge
from urdfctl.smoke.tasks import CRUISE, ControllerTask, Drive, Goal, MotionFamily
from urdfctl.startup.records import NamedTuple

ERROR_OF_STEP, LEAST_ERROR, DROOP = 0.25, 0.01, 1.5
"""A joint reaches its target if its error is at most the largest of three limits: a quarter of its step; 0.01 rad or m,
but at most half of its step; 1.5 times the weight on it divided by the p gain."""
HALF = 0.5
FULL = 0.99
"""From this fraction of its limit on, a motor gives all the effort that it has."""
SWING_OF_STEP, SPEED_OF_STEP = 0.2, 0.5
"""A joint oscillates if both hold in the last quarter of the motion: it swings by more than 0.2 of its step, and its
root mean square speed is more than 0.5 of its step per second."""
SWING_TOGETHER, SPEED_TOGETHER = 0.02, 0.1
"""The same limits when all control loops run together, in rad or m, and rad/s or m/s."""
MOVED = 0.5
"""A joint must move by more than this fraction of what a velocity command asks for."""
FASTER = 2.0
"""A velocity loop runs away if it ends faster than the target by this factor."""
PUSHED = 1e-4
"""An effort command must move a joint by at least this, in rad or m."""
PAST_LIMIT = 0.02
"""A joint may exceed its position limits by this, in rad or m."""
PAST_VELOCITY, SLACK = 1.2, 0.01
"""A joint may exceed its velocity limit by this factor, plus this much in rad/s or m/s."""
MIMIC = 0.02
"""A joint may be this far from where it should mimic another one, in rad or m."""
OF_SPAN = 0.1
"""A joint of a small range may exceed its limits, or be off, by this fraction of its range."""
STRAIGHT = (0.85, 1.15)
"""The range of the distance driven, as a fraction of the commanded one."""
SLIPPING = 0.25
"""The lower end of each range is lower by this in MuJoCo, whose soft contacts let wheels slip."""
STRAIGHT_YAW = 0.15
"""A base may turn by this while it drives straight, in rad."""
ROLLED = 0.8
"""Wheels that turn less than this fraction of what they are commanded are too weak."""
LEAST_TURN = 0.05
"""A base must turn by at least this fraction of the commanded angle, in every engine."""
TURNS = {"two": (0.8, 1.2), "skid": (0.05, math.inf), "steered": (0.3, 1.5)}
"""The range of the angle turned, as a fraction of the commanded one: for two wheels, for more (how far they slip is not
known, so that only the direction counts), and for steered wheels (they slip a little)."""


class Track(NamedTuple):
    """The motion of a joint, one value for each update: in rad or m, and rad/s or m/s for `velocities`.

    `efforts` are what its motor gave, in N m or N.
    """

    positions: list[float]
    velocities: list[float]
    wanted: list[float]
    efforts: list[float]


def joint_troubles(
    task: ControllerTask, goals: Sequence[Goal], tracks: Sequence[Track], seconds: float
) -> Iterator[Trouble]:
    """Yield what is wrong with the motion of a controller's joints."""
    for index, (goal, track) in enumerate(zip(goals, tracks, strict=True)):
        if not (task.family is MotionFamily.FORWARD and task.interface == "effort"):
            yield from limit_troubles(task, goal, track)
        if judged_by_end(task):
            yield from _arrived(task, goal, track, task.gains[index].p if task.gains else 0.0)
        elif task.family is MotionFamily.FORWARD and task.interface == "effort":
            yield from _pushed(task, goal, track)
        else:
            yield from _turned(task, goal, track, seconds)


def judged_by_end(task: ControllerTask) -> bool:
    """Return whether the joints of a task must reach a position, not a velocity, and are not only pushed."""
    return task.family is not MotionFamily.VELOCITY_PID and (
        task.family is not MotionFamily.FORWARD or task.interface not in ("velocity", "effort")
    )


def _trouble(fault: FaultWithMessage, task: ControllerTask, goal: Goal, *notes: str, **fields: object) -> Trouble:
    hinge = goal.hinge
    return trouble_of(fault, f"joint:{hinge.name}", task.controller, notes, joint=hinge.name, unit=hinge.unit, **fields)


def within_span(slack: float, hinge: Hinge) -> float:
    """Return a slack in rad or m that is small for the range of a joint too."""
    low, high = hinge.span
    return min(slack, OF_SPAN * (high - low))


def limit_troubles(task: ControllerTask, goal: Goal, track: Track) -> Iterator[Trouble]:
    """Yield where a joint exceeds its limits."""
    lower, upper = goal.hinge.span
    least, most = min(track.positions), max(track.positions)
    slack = within_span(PAST_LIMIT, goal.hinge)
    if goal.hinge.type != "continuous" and (least < lower - slack or most > upper + slack):
        yield _trouble(joint_leaves_limits, task, goal, least=least, most=most, lower=lower, upper=upper)
    fastest, limit = max(map(abs, track.velocities)), goal.hinge.velocity
    if task.family is not MotionFamily.POSITION_PID and limit and fastest > PAST_VELOCITY * limit + SLACK:
        yield _trouble(joint_too_fast, task, goal, fastest=fastest, limit=limit)


def tolerance_of(task: ControllerTask, goal: Goal, p: float) -> float:
    """Return how far from its target a joint may end, in rad or m; p: the p gain of its loop."""
    step = abs(goal.by)
    droop = DROOP * abs(goal.weight) / p if task.interface == "effort" and p > 0 else 0.0
    return max(ERROR_OF_STEP * step, min(LEAST_ERROR, HALF * step), droop)


def _arrived(task: ControllerTask, goal: Goal, track: Track, p: float) -> Iterator[Trouble]:
    last = track.positions[-max(1, len(track.positions) // 4) :]
    swing, speed = max(last) - min(last), _root_mean_square(track.velocities[-len(last) :])
    step = abs(goal.by)
    if swing > SWING_OF_STEP * step and speed > SPEED_OF_STEP * step:
        yield _trouble(joint_oscillates, task, goal, _advice(task, goal, track.efforts[-len(last) :]), swing=swing)
        return
    error = abs(track.positions[-1] - goal.end)
    if error > tolerance_of(task, goal, p):
        moved = track.positions[-1] - goal.start
        gain = "" if task.interface == "position" else " and its p gain"
        notes = [f"it hardly moves: check its effort limit{gain}"] if abs(moved) < ERROR_OF_STEP * step else []
        yield _trouble(joint_does_not_follow, task, goal, *notes, expected=goal.by, actual=moved)


def _advice(task: ControllerTask, goal: Goal, efforts: Sequence[float]) -> str:
    """What makes a joint stand still whose motor gave these efforts while it swung."""
    hinge = goal.hinge
    unit = "N" if hinge.type == "prismatic" else "N m"
    if hinge.effort and abs(goal.weight) > hinge.effort:
        return f"its load of {abs(goal.weight):.3g} {unit} is more than its effort limit of {hinge.effort:g} {unit}"
    if _is_at_limit(goal, efforts):
        return f"its motor is at its effort limit of {hinge.effort:g} {unit}: raise the limit, or lower the gains"
    if task.interface == "position":
        return "the hardware holds the position: check the masses and inertias that the joint moves"
    return "raise the d gain, or lower the p gain"


def _is_at_limit(goal: Goal, efforts: Sequence[float]) -> bool:
    limit = goal.hinge.effort
    return limit is not None and limit > 0 and sum(abs(each) >= FULL * limit for each in efforts) > HALF * len(efforts)


def are_overwhelmed(task: ControllerTask, goals: Sequence[Goal], tracks: Sequence[Track]) -> bool:
    """Return whether a motor that holds a position, and can bear its load, ran at full effort most of the time."""
    if task.interface != "position":
        return False
    pairs = zip(goals, tracks, strict=True)
    return any(
        _is_at_limit(goal, track.efforts) and abs(goal.weight) < (goal.hinge.effort or 0.0) for goal, track in pairs
    )


def _turned(task: ControllerTask, goal: Goal, track: Track, seconds: float) -> Iterator[Trouble]:
    expected = goal.by if task.family is MotionFamily.FORWARD else math.copysign(CRUISE, goal.by) * seconds
    moved = track.positions[-1] - goal.start
    last = track.velocities[-max(1, len(track.velocities) // 4) :]
    runs_away = task.family is MotionFamily.VELOCITY_PID and max(map(abs, last)) > FASTER * CRUISE
    if moved * expected <= 0 or abs(moved) <= MOVED * abs(expected) or runs_away:
        command = f"should move by {expected:+.3g} {goal.hinge.unit}"
        yield _trouble(joint_moves_wrong_way, task, goal, command=command, actual=moved)


def _pushed(task: ControllerTask, goal: Goal, track: Track) -> Iterator[Trouble]:
    moved = max((position - goal.start for position in track.positions), key=abs)
    if moved * goal.by <= 0 or abs(moved) < PUSHED:
        command = f"is pushed towards {goal.by:+.2g} {goal.hinge.unit}"
        yield _trouble(joint_moves_wrong_way, task, goal, command=command, actual=moved)


def together_troubles(
    tasks: Sequence[ControllerTask], goals: Sequence[Goal], tracks: Sequence[Track]
) -> Iterator[Trouble]:
    """Yield the first joint that swings when all control loops run together."""
    owners = {joint: task for task in tasks for joint in task.joints}
    for goal, track in zip(goals, tracks, strict=True):
        last = track.positions[-max(1, len(track.positions) // 4) :]
        swing, speed = max(last) - min(last), _root_mean_square(track.velocities[-len(last) :])
        if swing > SWING_TOGETHER and speed > SPEED_TOGETHER:
            note = "the joints disturb each other: lower the gains"
            yield _trouble(joints_oscillate_together, owners[goal.hinge.name], goal, note, swing=swing)
            return


def _root_mean_square(values: Sequence[float]) -> float:
    return math.sqrt(sum(value * value for value in values) / len(values))


# -- mobile bases ----------------------------------------------------------------------------------------------------


class Journey(NamedTuple):
    """The way of a base in the test.

    before, after: where it starts and ends.
    yaw: the angle by which it turns, in rad.
    distance, angle: what its controller was commanded, in m and rad.
    facing: the direction of the frame that the controller drives, from the root's x axis, in rad.
    rolled: how far its wheels turned, as a fraction of what they were commanded.
    """

    before: BasePose
    after: BasePose
    yaw: float
    distance: float
    angle: float
    facing: float = 0.0
    rolled: float = 1.0

    @property
    def ahead(self) -> float:
        """The distance in the direction that it first faced, in m."""
        x, y = self.after.x - self.before.x, self.after.y - self.before.y
        way = self.before.yaw + self.facing
        return x * math.cos(way) + y * math.sin(way)


def forward_troubles(task: ControllerTask, journey: Journey, slipping: float = 0.0) -> Iterator[Trouble]:
    """Yield what is wrong if a base does not drive straight forward; `slipping` lowers the accepted range."""
    distance = journey.distance
    low, high = STRAIGHT[0] - slipping, STRAIGHT[1]
    subject, controller = f"controller:{task.controller}", task.controller
    if not low < journey.ahead / distance < high:
        notes = tuple(_why_not(journey.ahead / distance, journey.rolled))
        expected, actual = f"{distance:.2g} m forward", f"it moves by {journey.ahead:+.3g} m"
        yield trouble_of(does_not_drive_forward, subject, controller, notes, expected=expected, actual=actual)
    elif abs(journey.yaw) > STRAIGHT_YAW + slipping:
        actual = f"it turns by {journey.yaw:+.2g} rad"
        yield trouble_of(does_not_drive_forward, subject, controller, expected="straight forward", actual=actual)


def _why_not(ratio: float, rolled: float) -> Iterator[str]:
    if ratio < -0.1:  # noqa: PLR2004
        yield "the wheels turn backwards: check the axes of their joints"
    elif ratio < 0.1:  # noqa: PLR2004
        yield "the wheels do not roll: check that they touch the ground, and check their axes and effort limits"
    elif rolled < ROLLED:
        yield "the wheels do not reach their speed: check their effort limits, and the mass of the robot"
    else:
        yield f"the wheels slip, or their real radius is {ratio / rolled:.2g} times the one that the controller uses"


def turn_troubles(task: ControllerTask, drive: Drive, journey: Journey, slipping: float = 0.0) -> Iterator[Trouble]:
    """Yield what is wrong if a base does not turn left as commanded; `slipping` lowers the accepted range."""
    angle = journey.angle
    kind = "steered" if drive.steered else "skid" if drive.is_skidding else "two"
    low, high = TURNS[kind]
    ratio = journey.yaw / angle if angle else 1.0
    if max(low - slipping, LEAST_TURN) < ratio < high:
        return
    note = "it turns the other way: check whether left and right are swapped, or a steering axis points down"
    notes = (note,) if ratio < 0 else ()
    subject = f"controller:{task.controller}"
    yield trouble_of(does_not_turn_left, subject, task.controller, notes, expected=angle, actual=journey.yaw)
