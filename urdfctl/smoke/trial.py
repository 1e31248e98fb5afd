"""The simulation of one robot in one engine: let it settle, then let each controller move its joints."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.rules.smoke.mimic_not_kept import mimic_not_kept
from urdfctl.rules.smoke.robot_tips_over import robot_tips_over
from urdfctl.rules.smoke.simulation_explodes import simulation_explodes
from urdfctl.rules.smoke.wheel_off_the_ground import wheel_off_the_ground
from urdfctl.smoke.checks import (
    MIMIC,
    SLIPPING,
    Journey,
    Track,
    forward_troubles,
    joint_troubles,
    together_troubles,
    turn_troubles,
)
from urdfctl.smoke.engines import STEP, Engine, Refused, Setup, open_engine
from urdfctl.smoke.ground import TIPPED
from urdfctl.smoke.loads import gravity_load
from urdfctl.smoke.mechanism import Hinge, Mechanism
from urdfctl.smoke.motions import FORWARD, FREELY, TURN, Goal, Loop, Motion, Wheels, goal_of, hold, motion_of
from urdfctl.smoke.results import ROBOT, Curve, Trouble, trouble_of
from urdfctl.smoke.tasks import Drive, Family, Task, is_loop
from urdfctl.startup.hints import Any
from urdfctl.startup.records import NamedTuple

SETTLING = 0.5
"""The time in which a robot comes to rest, in s."""
MOTION = 2.0
"""The default time for which each controller moves its joints, in s; half of it for a controller without a loop."""
PUSHING = 0.2
"""The time for which an effort pushes a joint, in s."""
MOST_STEPS = 10
"""The maximum number of simulation steps between two position commands."""
TOGETHER = 0.05
"""The step that all loops are commanded together, in rad or m."""
_EXPLODED = 1e4
"""From this position on, in rad or m, the simulation has exploded."""
_SAMPLES = 60
"""The approximate number of samples of a curve."""


class Plan(NamedTuple):
    """The input of an engine's worker.

    `engine` is the name of the engine. `urdf` is the text that the engine loads. `rate` is the update rate of the
    controllers, in Hz. `fixed` is whether the root link is fixed to the world. `shapeless` is whether collision
    geometry was left out. `duration` is the time for which each controller moves, in s. `gui` shows a window.
    """

    engine: str
    urdf: str
    mechanism: Mechanism
    tasks: tuple[Task, ...]
    rate: float
    fixed: bool
    shapeless: bool = False
    duration: float = MOTION
    gui: bool = False

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Plan:
        """Return the plan that plain data holds."""
        mechanism = Mechanism.from_json(data["mechanism"])
        return cls(**{**data, "mechanism": mechanism, "tasks": tuple(map(Task.from_json, data["tasks"]))})

    def to_json(self) -> dict[str, Any]:
        """Return the plan as plain data."""
        tasks = [task.to_json() for task in self.tasks]
        return {**self._asdict(), "mechanism": self.mechanism.to_json(), "tasks": tasks}


class Tried(NamedTuple):
    """The result of a simulation.

    `moved` holds the controllers that moved their joints. `unjudged` holds those that could not be judged, with the
    reason. `seconds` is how long it took. `refused` is why the engine rejects the robot, or empty.
    """

    troubles: tuple[Trouble, ...] = ()
    moved: tuple[str, ...] = ()
    unjudged: Mapping[str, str] = {}
    curves: tuple[Curve, ...] = ()
    seconds: float = 0.0
    refused: str = ""

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Tried:
        """Return the result that plain data holds."""
        troubles = [Trouble.from_json(fields) for fields in data["troubles"]]
        curves = [Curve(*fields[:3], *map(tuple, fields[3:])) for fields in data["curves"]]
        return cls(**{**data, "troubles": tuple(troubles), "curves": tuple(curves), "moved": tuple(data["moved"])})


def tried(plan: Plan) -> Tried:
    """Return the result of simulating a plan."""
    began = time.perf_counter()
    mechanism = plan.mechanism
    weightless = [body.name for body in mechanism.bodies.values() if not body.falls]
    rolling = {name for task in plan.tasks if task.drive for name in (*_driven(task.drive), *task.drive.steered)}
    wheels = [hinge.child for hinge in mechanism.hinges if hinge.name in rolling]
    setup = Setup(
        urdf=plan.urdf,
        root=mechanism.root,
        fixed=plan.fixed,
        start=mechanism.start(),
        weightless=weightless,
        wheels=wheels,
        gui=plan.gui,
    )
    try:
        engine = open_engine(plan.engine, setup)
    except Refused as refusal:
        return Tried(refused=str(refusal))
    trial = _Trial(plan, engine)
    try:
        trial.run()
    finally:
        engine.close()
    seconds = time.perf_counter() - began
    unjudged = {name: why for name, why in trial.unjudged.items() if name not in trial.moved}
    return Tried(tuple(trial.troubles), tuple(trial.moved), unjudged, tuple(trial.curves), seconds)


class _Exploded(Exception):
    """A position is not a finite number, or far too large."""


class _Trial:
    def __init__(self, plan: Plan, engine: Engine) -> None:
        self._plan, self._engine = plan, engine
        self._mechanism = plan.mechanism
        self._hinges = {hinge.name: hinge for hinge in plan.mechanism.hinges if hinge.moves}
        self._every(max(1, round(1 / plan.rate / STEP)))
        self._claimed = {joint for task in plan.tasks for joint in task.joints}
        self._wheels = {name for task in plan.tasks for name in _wheels(task)}
        self.troubles: list[Trouble] = []
        self.moved: list[str] = []
        self.unjudged: dict[str, str] = {}
        self.curves: list[Curve] = []

    def run(self) -> None:
        """Simulate the whole plan; an explosion ends it."""
        for task in self._plan.tasks:
            self.unjudged[task.controller] = "not simulated: the robot did not settle"
        try:
            if not self._settled():
                return
            for task in self._plan.tasks:
                self._run_task(task)
            self._together()
            self._mimics()
        except _Exploded:
            if not any(trouble.code == simulation_explodes.code for trouble in self.troubles):
                self.troubles.append(trouble_of(simulation_explodes, ROBOT, when=""))

    # -- at rest -----------------------------------------------------------------------------------------------------

    def _settled(self) -> bool:
        for hinge in self._mechanism.movable:
            free = not self._plan.fixed and hinge.type == "continuous" and hinge.name not in self._claimed
            if hinge.name in self._wheels:
                self._engine.at_velocity(hinge.name, 0.0, FREELY)
            elif not free:
                hold(self._engine, hinge, hinge.start)
        self._pass(SETTLING)
        if self._plan.fixed:
            return True
        standing = self._engine.standing()
        tipped = max(abs(standing.roll), abs(standing.pitch)) > TIPPED
        touching = self._engine.touching()
        driven = (name for task in self._plan.tasks if task.drive for name in _driven(task.drive))
        lifted = [name for name in dict.fromkeys(driven) if self._hinges[name].child not in touching]
        if self._plan.shapeless and (tipped or lifted):
            for task in self._plan.tasks:
                self.unjudged[task.controller] = "not simulated: collision geometry under the robot is missing"
            return False
        if tipped:
            notes = ("check that it has enough wheels or casters",)
            tipping = trouble_of(robot_tips_over, ROBOT, None, notes, roll=standing.roll, pitch=standing.pitch)
            self.troubles.append(tipping)
        for name in lifted:
            owner = next(task.controller for task in self._plan.tasks if name in task.joints)
            self.troubles.append(trouble_of(wheel_off_the_ground, f"joint:{name}", owner, joint=name))
        return not tipped

    def _pass(self, seconds: float) -> None:
        """Simulate some seconds with unchanged commands."""
        for _ in range(max(1, round(seconds / self._period))):
            self._update()

    def _update(self) -> None:
        """Simulate one period: command the mimic joints, then run the engine's steps."""
        engine = self._engine
        for hinge in self._hinges.values():
            if self._follows(hinge):
                engine.to_position(hinge.name, self._followed(hinge), FREELY, FREELY)
        for _ in range(self._steps):
            engine.step()
        place = engine.standing()
        watched = [*place, *(engine.position(name) for name in self._hinges)]
        if not all(math.isfinite(value) and abs(value) < _EXPLODED for value in watched):
            raise _Exploded

    def _follows(self, hinge: Hinge) -> bool:
        """Whether a joint mimics another one, and no controller moves it directly."""
        return hinge.mimic is not None and hinge.mimic[0] in self._hinges and hinge.name not in self._claimed

    def _followed(self, hinge: Hinge) -> float:
        leader, factor, offset = hinge.mimic or ("", 0.0, 0.0)
        return self._engine.position(leader) * factor + offset

    # -- controllers -------------------------------------------------------------------------------------------------

    def _run_task(self, task: Task) -> None:
        if task.family is Family.STRUCTURAL:
            self.unjudged[task.controller] = f"not simulated: {task.why}"
            return
        if task.family is Family.NOTHING:
            self.moved.append(task.controller)
            return
        unknown = [name for name in task.joints if name not in self._hinges]
        if unknown:
            self.unjudged[task.controller] = f"not simulated: '{unknown[0]}' is not a movable joint"
            return
        try:
            judged = self._drive(task, task.drive) if task.drive else self._move(task)
        except _Exploded:
            subject, when = f"controller:{task.controller}", f" while controller '{task.controller}' moves its joints"
            self.troubles.append(trouble_of(simulation_explodes, subject, task.controller, when=when))
            raise
        if judged:
            self.moved.append(task.controller)

    def _push_each(self, task: Task, goals: Sequence[Goal]) -> None:
        """Push one joint after the other while the others are held: a push would go through the whole arm."""
        for name in [goal.hinge.name for goal in goals]:
            goal = self._goals([name], self._plan.duration)[0]
            motion = motion_of(self._engine, task, [goal], PUSHING)
            tracks = self._tracked(motion, [goal], PUSHING)
            self.troubles += joint_troubles(task, [goal], tracks, PUSHING)
            self.curves.append(self._curve(task.controller, name, "position", [], tracks[0].positions))
            hold(self._engine, goal.hinge, self._engine.position(name))
        self._pass(0.1)

    def _every(self, steps: int) -> None:
        """Update the controllers once in a number of steps."""
        self._steps, self._period = steps, steps * STEP

    def _goals(self, names: Sequence[str], duration: float) -> list[Goal]:
        positions = {name: self._engine.position(name) for name in self._hinges}
        weights = gravity_load(self._mechanism, positions) if self._plan.fixed else {}
        return [goal_of(self._hinges[name], positions[name], weights.get(name, 0.0), duration) for name in names]

    def _move(self, task: Task) -> bool:
        loop = task.family in (Family.POSITION_PID, Family.VELOCITY_PID) or task.interface != "position"
        seconds = self._plan.duration * (1.0 if loop else 0.5)
        goals = self._goals(task.joints, seconds)
        if task.family is Family.FORWARD and task.interface == "effort":
            self._push_each(task, goals)
            return True
        motion = motion_of(self._engine, task, goals, seconds)
        steps = self._steps
        if not loop:  # a driver updates positions more often than a slow manager
            self._every(min(steps, MOST_STEPS))
        tracks = self._tracked(motion, goals, seconds)
        self._every(steps)
        self.troubles += joint_troubles(task, goals, tracks, seconds)
        of_velocity = task.family is Family.VELOCITY_PID or (
            task.family is Family.FORWARD and task.interface == "velocity"
        )
        quantity = "velocity" if of_velocity else "position"
        for goal, track in zip(goals, tracks, strict=True):
            measured = track.velocities if of_velocity else track.positions
            self.curves.append(self._curve(task.controller, goal.hinge.name, quantity, track.wanted, measured))
        for goal in goals:
            hold(self._engine, goal.hinge, self._engine.position(goal.hinge.name))
        self._pass(0.1)
        return True

    def _tracked(self, motion: Motion, goals: Sequence[Goal], seconds: float) -> list[Track]:
        tracks = [Track([], [], []) for _ in goals]
        for update in range(max(4, round(seconds / self._period))):
            motion.update(update * self._period, self._period)
            self._update()
            for index, (goal, track) in enumerate(zip(goals, tracks, strict=True)):
                track.positions.append(self._engine.position(goal.hinge.name))
                track.velocities.append(self._engine.velocity(goal.hinge.name))
                track.wanted.append(motion.wanted(index))
        return tracks

    def _curve(
        self, controller: str, joint: str, quantity: str, wanted: Sequence[float], measured: Sequence[float]
    ) -> Curve:
        every = max(1, len(measured) // _SAMPLES)
        seconds = tuple(round((n + 1) * self._period, 4) for n in range(0, len(measured), every))
        commanded, did = (tuple(round(value, 5) for value in values[::every]) for values in (wanted, measured))
        return Curve(
            controller=controller, joint=joint, quantity=quantity, seconds=seconds, commanded=commanded, measured=did
        )

    def _together(self) -> None:
        """Run all loops together: joints that are still when they are moved alone may disturb each other."""
        tasks = [task for task in self._plan.tasks if is_loop(task) and task.controller in self.moved]
        tasks = [task for task in tasks if task.family is not Family.VELOCITY_PID]
        owners: dict[str, tuple[Task, int]] = {}
        for task in tasks:
            for index, joint in enumerate(task.joints):
                owners.setdefault(joint, (task, index))
        if len({task.controller for task, _ in owners.values()}) < 2:  # noqa: PLR2004
            return
        goals = [
            goal._replace(by=math.copysign(min(TOGETHER, abs(goal.by)), goal.by))
            for goal in self._goals(list(owners), self._plan.duration)
        ]
        gains = [task.gains[index] for task, index in owners.values()]
        motion = Loop(self._engine, goals, gains, "effort", lambda goal, _: (goal.end, 0.0))
        tracks = self._tracked(motion, goals, self._plan.duration)
        self.troubles += together_troubles(tasks, goals, tracks)

    def _mimics(self) -> None:
        for hinge in self._hinges.values():
            if self._follows(hinge) and hinge.mimic:
                apart = abs(self._engine.position(hinge.name) - self._followed(hinge))
                if apart > MIMIC:
                    fields = {"joint": hinge.name, "distance": apart, "unit": hinge.unit, "leader": hinge.mimic[0]}
                    self.troubles.append(trouble_of(mimic_not_kept, f"joint:{hinge.name}", None, (), **fields))

    # -- mobile bases ------------------------------------------------------------------------------------------------

    def _drive(self, task: Task, given: Drive) -> bool:
        drive = measured(self._mechanism, given)
        if not drive.radius or (drive.left and not drive.separation) or (drive.steered and not drive.wheelbase):
            self.unjudged[task.controller] = "not simulated: the radius or separation of its wheels is unknown"
            return False
        seconds = self._plan.duration
        slipping = SLIPPING if self._plan.engine == "mujoco" else 0.0
        straight = Wheels(self._engine, self._hinges, drive, FORWARD, 0.0)
        troubles = list(forward_troubles(task, self._journey(straight, task, "ahead", seconds), slipping))
        turning = Wheels(self._engine, self._hinges, drive, FORWARD if drive.steered else 0.0, TURN)
        if not troubles:
            troubles += turn_troubles(
                task, drive, self._journey(turning, task, "yaw", seconds), turning.steering, slipping
            )
        self.troubles += troubles
        for name in _driven(drive):
            self._engine.at_velocity(name, 0.0, FREELY)
        self._pass(0.1)
        return True

    def _journey(self, wheels: Wheels, task: Task, quantity: str, seconds: float) -> Journey:
        before = now = self._engine.standing()
        yaw, yaws, ahead = 0.0, [], []
        for update in range(round(seconds / self._period)):
            wheels.update(update * self._period, self._period)
            self._update()
            last, now = now, self._engine.standing()
            yaw += (now.yaw - last.yaw + math.pi) % (2 * math.pi) - math.pi
            yaws.append(yaw)
            ahead.append(Journey(before, now, yaw, seconds).ahead)
        commanded = [wheels.wanted(0 if quantity == "ahead" else 1) * (n + 1) * self._period for n in range(len(yaws))]
        driven = ahead if quantity == "ahead" else yaws
        self.curves.append(self._curve(task.controller, "base", quantity, commanded, driven))
        return Journey(before, now, yaw, seconds)


def _wheels(task: Task) -> Iterator[str]:
    if task.drive:
        yield from _driven(task.drive)


def _driven(drive: Drive) -> tuple[str, ...]:
    return (*drive.left, *drive.right, *drive.driven)


def measured(mechanism: Mechanism, drive: Drive) -> Drive:
    """Return a drive with the measures that its controller lacks taken from the robot, as in ROS 1."""
    poses = mechanism.poses(mechanism.start())
    wheels = [hinge for name in _driven(drive) if (hinge := mechanism.hinge(name)) is not None]
    radius = drive.radius or next((r for hinge in wheels if (r := mechanism.bodies[hinge.child].radius)), 0.0)
    separation, wheelbase = drive.separation, drive.wheelbase
    if drive.left and drive.right and not separation:
        sides = [
            poses[hinge.child].place[1] for name in (drive.left[0], drive.right[0]) if (hinge := mechanism.hinge(name))
        ]
        separation = abs(sides[0] - sides[-1])
    return drive._replace(radius=radius, separation=separation, wheelbase=wheelbase)
