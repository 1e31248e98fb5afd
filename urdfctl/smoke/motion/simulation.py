"""A robot in an engine: time passes, joints are followed, and what goes wrong in it ends the simulation."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Sequence

from urdfctl.smoke.engines import STEP, BasePose, Engine
from urdfctl.smoke.motion.checks import Track, judged_by_end, tolerance_of
from urdfctl.smoke.motion.motions import Motion
from urdfctl.smoke.motion.plan import MotionPlan
from urdfctl.smoke.results import Curve
from urdfctl.smoke.robot import TIPPED, Hinge
from urdfctl.smoke.tasks import FREELY, ControllerTask, Goal, MotionFamily

_EXPLODED = 1e4
"""From this position on, in rad or m, the simulation has exploded."""
_WATCHED = 0.01
"""A robot is watched for exploding or tipping over once in this time, in s: asking an engine is as slow as a step."""
_SAMPLES = 60
"""The approximate number of samples of a curve."""


class Exploded(Exception):
    """A position is not a finite number, or far too large."""


class Tipped(Exception):
    """The robot, which stood before, tips over; its roll and pitch are in rad."""

    def __init__(self, roll: float, pitch: float) -> None:
        super().__init__(roll, pitch)
        self.roll, self.pitch = roll, pitch


class OutOfTime(Exception):
    """The engine has used the processor time that it may use."""


class RobotSimulation:
    """A robot in an engine, whose controllers are updated at their rate.

    `hinges` holds the joints that can move, by name, and `claimed` the names of those that controllers move. Once it is
    told how the robot stands at rest, it watches that the robot does not tip over.
    """

    def __init__(self, plan: MotionPlan, engine: Engine, began: float) -> None:
        self.plan, self.engine, self.mechanism = plan, engine, plan.mechanism
        self.hinges = {hinge.name: hinge for hinge in plan.mechanism.hinges if hinge.moves}
        self.claimed = {joint for task in plan.tasks for joint in task.joints}
        self._followers = [hinge for hinge in self.hinges.values() if self.follows(hinge)]
        self._deadline = began + plan.budget
        self.at_rest: BasePose | None = None
        self.every(max(1, round(1 / plan.rate / STEP)))

    def every(self, steps: int) -> None:
        """Update the controllers once in a number of steps."""
        self.steps, self.period = steps, steps * STEP
        self._unwatched = self._at_once = max(1, round(_WATCHED / self.period))

    def run_for(self, seconds: float) -> None:
        """Simulate some seconds with unchanged commands."""
        for _ in range(max(1, round(seconds / self.period))):
            self.update()

    def update(self) -> None:
        """Simulate one period: command the mimic joints, then run the engine's steps."""
        engine = self.engine
        for hinge in self._followers:
            engine.to_position(hinge.name, self.followed(hinge), FREELY, FREELY)
        for _ in range(self.steps):
            engine.step()
        self._unwatched -= 1
        if not self._unwatched:
            self._unwatched = self._at_once
            self._watch()

    def _watch(self) -> None:
        """Raise what ends the simulation, if it happened."""
        engine = self.engine
        if time.process_time() > self._deadline:
            raise OutOfTime
        place = engine.base_pose()
        watched = [*place, *(engine.position(name) for name in self.hinges)]
        if not all(math.isfinite(value) and abs(value) < _EXPLODED for value in watched):
            raise Exploded
        rest = self.at_rest
        if rest and max(abs(place.roll - rest.roll), abs(place.pitch - rest.pitch)) > TIPPED:
            raise Tipped(place.roll, place.pitch)

    def follows(self, hinge: Hinge) -> bool:
        """Whether a joint mimics another one, and no controller moves it directly."""
        return hinge.mimic is not None and hinge.mimic[0] in self.hinges and hinge.name not in self.claimed

    def followed(self, hinge: Hinge) -> float:
        """Return the position at which a mimic joint should be now."""
        leader, factor, offset = hinge.mimic or ("", 0.0, 0.0)
        return self.engine.position(leader) * factor + offset

    def tracked(self, motions: Sequence[tuple[Motion, Sequence[Goal]]], seconds: float) -> list[list[Track]]:
        """Return what the joints of some goals do while motions command them, all at once, for some seconds."""
        tracks = [[Track([], [], [], []) for _ in goals] for _, goals in motions]
        for update in range(max(4, round(seconds / self.period))):
            for motion, _ in motions:
                motion.update(update * self.period, self.period)
            self.update()
            for (motion, goals), of_motion in zip(motions, tracks, strict=True):
                for index, (goal, track) in enumerate(zip(goals, of_motion, strict=True)):
                    track.positions.append(self.engine.position(goal.hinge.name))
                    track.velocities.append(self.engine.velocity(goal.hinge.name))
                    track.wanted.append(motion.wanted(index))
                    track.efforts.append(self.engine.effort(goal.hinge.name))
        return tracks

    def curves(self, task: ControllerTask, goals: Sequence[Goal], tracks: Sequence[Track]) -> Iterator[Curve]:
        """Yield the curves of a controller's joints. A joint that is pushed has no commanded position."""
        is_forwarded = task.family is MotionFamily.FORWARD
        of_velocity = task.family is MotionFamily.VELOCITY_PID or (is_forwarded and task.interface == "velocity")
        is_pushed = is_forwarded and task.interface == "effort"
        for index, (goal, track) in enumerate(zip(goals, tracks, strict=True)):
            band = None
            if judged_by_end(task):
                slack = tolerance_of(task, goal, task.gains[index].p if task.gains else 0.0)
                band = goal.end - slack, goal.end + slack
            yield self.curve(
                task.controller,
                goal.hinge.name,
                "velocity" if of_velocity else "position",
                [] if is_pushed else track.wanted,
                track.velocities if of_velocity else track.positions,
                efforts=track.efforts,
                band=band,
            )

    def curve(
        self,
        controller: str,
        joint: str,
        quantity: str,
        wanted: Sequence[float],
        measured: Sequence[float],
        *,
        efforts: Sequence[float] = (),
        band: tuple[float, float] | None = None,
    ) -> Curve:
        """Return a joint's motion as a curve with few samples.

        efforts: of its motor, in N m or N. band: between which values it must end.
        """
        every = max(1, len(measured) // _SAMPLES)
        seconds = tuple(round((n + 1) * self.period, 4) for n in range(0, len(measured), every))
        commanded, did = (tuple(round(value, 5) for value in values[::every]) for values in (wanted, measured))
        hinge = self.hinges.get(joint)
        most = hinge.effort if hinge and hinge.effort else math.inf
        shares = [100 * effort / most for effort in efforts[::every]] if most < math.inf else []
        return Curve(
            controller=controller,
            joint=joint,
            quantity=quantity,
            seconds=seconds,
            commanded=commanded,
            measured=did,
            efforts=tuple(float(f"{share:.3g}") for share in shares),
            band=band,
            limits=_limits(hinge, quantity) if hinge else None,
            unit=_unit(hinge, quantity),
        )


def _limits(hinge: Hinge, quantity: str) -> tuple[float, float] | None:
    """The limits of a joint in a quantity, if it has any."""
    if quantity == "velocity":
        return (-hinge.velocity, hinge.velocity) if hinge.velocity else None
    if hinge.type == "continuous" or hinge.lower is None or hinge.upper is None:
        return None
    return hinge.span


def _unit(hinge: Hinge | None, quantity: str) -> str:
    """The unit of a quantity of a joint, or of a base without one."""
    if hinge is None:
        return "rad" if quantity == "yaw" else "m"
    return f"{hinge.unit}/s" if quantity == "velocity" else hinge.unit
