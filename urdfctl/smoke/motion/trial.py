"""The simulation of one robot in one engine: let it settle, then let each controller move its joints."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Sequence

from urdfctl.rules.smoke.mimic_not_kept import mimic_not_kept
from urdfctl.rules.smoke.robot_tips_over import robot_tips_over
from urdfctl.rules.smoke.simulation_explodes import simulation_explodes
from urdfctl.rules.smoke.wheel_off_the_ground import wheel_off_the_ground
from urdfctl.smoke.engines import Engine, RobotRejected, open_engine
from urdfctl.smoke.motion.checks import MIMIC, are_overwhelmed, joint_troubles, together_troubles, within_span
from urdfctl.smoke.motion.mobile_base import drive_base, turn_rollers, wheels_of_drives
from urdfctl.smoke.motion.motions import PidLoop, hold, motion_of
from urdfctl.smoke.motion.parallel_groups import groups_of, is_motor
from urdfctl.smoke.motion.plan import MotionPlan, SimulationResult
from urdfctl.smoke.motion.setup import engine_setup
from urdfctl.smoke.motion.simulation import Exploded, OutOfTime, RobotSimulation, Tipped
from urdfctl.smoke.motion.standing import why_not_standing
from urdfctl.smoke.motion.user_tasks import perform_task
from urdfctl.smoke.results import ROBOT, Curve, Trouble, trouble_of
from urdfctl.smoke.robot import GRIPS, SLIDES, TIPPED, gravity_load, moved_inertias
from urdfctl.smoke.tasks import FREELY, ControllerTask, Drive, Goal, MotionFamily, UserTask, goal_of, suspended_wheels

SETTLING = 0.5
"""The time in which a robot comes to rest, in s."""
PUSHING = 0.2
"""The time for which an effort pushes a joint, in s."""
RESTING = 0.1
"""The time in which joints that are held come to rest, in s."""
QUICKLY = 100.0
"""The acceleration with which an effort pushes a joint at most, in rad/s² or m/s²: light links would explode."""
PART_OF_WEIGHT = 0.1
"""A push is at least this fraction of the joint's weight, which is not known exactly."""
MOST_STEPS = 10
"""The maximum number of simulation steps between two position commands."""
TOGETHER = 0.05
"""The step that all loops are commanded together, in rad or m."""
GENTLY = 0.25
"""The part of its usual motion by which a motor is tried again that ran at full effort."""
HELD = "its base was held in the air"
ACTS = {
    "reads": ("started", "read"),
    "moves": ("started", "moved"),
    "follows": ("started", "moved", "followed", "held"),
    "drives": ("started", "drove", "turned"),
    "rolls": ("started", "turned its wheels"),
    "performs": ("started", "performed its task"),
}
"""Return what a controller was seen to do."""


def run_trial(plan: MotionPlan, seen: Callable[[SimulationResult], None] = lambda _: None) -> SimulationResult:
    """Return the result of simulating a plan. `seen` gets what is known after each group of controllers."""
    began = time.process_time()
    setup = engine_setup(plan)
    try:
        engine = open_engine(plan.engine, setup)
    except RobotRejected as refusal:
        return SimulationResult(refused=str(refusal))
    trial = MotionTrial(plan, engine, setup.stiff, began)
    try:
        trial.run(seen)
    finally:
        engine.close()
    if plan.ground_urdf and trial.acts:
        trial.lying = why_not_standing(plan, setup, began)
    return trial.result()


def seen_quantities(act: str, *, stood: bool) -> tuple[str, ...]:
    """What a controller was seen to do; if the whole robot stood, so did it."""
    return (*ACTS[act], "stood") if stood and act in ("moves", "follows") else ACTS[act]


def untested_joints(plan: MotionPlan, task: ControllerTask, lying: str) -> dict[str, str]:
    """Return what was not modelled while a controller was tested, with the reason.

    lying: why the robot does not stand.
    """
    if task.family is MotionFamily.NOTHING:
        return {}
    mechanism = plan.mechanism
    moved = (hinge.child for hinge in mechanism.hinges if hinge.name in task.joints)
    empty = [name for name in moved if not any(mechanism.bodies[part].mass for part in mechanism.body_of(name))]
    masses = {"mass": f"link '{empty[0]}' has none; 1 g was taken"} if empty else {}
    return {**masses, **dict(task.left_out), **_not_modelled(plan, task, lying)}


def _not_modelled(plan: MotionPlan, task: ControllerTask, lying: str) -> dict[str, str]:
    if task.rolling:
        return {"contact": "its wheels turned in the air; their rollers are not modelled"}
    if task.drive is None:
        standing = {"standing": lying} if lying and plan.fixed and not plan.mechanism.is_fixed else {}
        return {**standing, "contact": "links do not collide"}
    slipping = {"turning rate": "wheels slip; only the direction was tested"} if task.drive.is_skidding else {}
    return {**slipping, "friction": f"{GRIPS:g} for wheels and {SLIDES:g} for other parts, if <gazebo> gives none"}


class MotionTrial:
    """The test of a robot's controllers in an engine, one after the other, with what is found on the way."""

    def __init__(self, plan: MotionPlan, engine: Engine, stiff: Collection[str], began: float) -> None:
        self._simulation, self.stiff_joints, self._began = RobotSimulation(plan, engine, began), stiff, began
        self._plan, self._engine, self._hinges = plan, engine, self._simulation.hinges
        self.wheel_joints = set(wheels_of_drives(plan.tasks))
        self._suspended = {} if plan.fixed else suspended_wheels(plan.mechanism, plan.tasks)
        self.troubles: list[Trouble] = []
        self.moved: list[str] = []
        self.unjudged: dict[str, str] = {}
        self.acts: dict[str, str] = {}
        self.times: dict[str, float] = {}
        self.curves: list[Curve] = []
        self.lying = plan.why_held or HELD
        self._inertias = moved_inertias(plan.mechanism)
        self._bases: dict[Drive, tuple[str, bool]] = {}

    def result(self) -> SimulationResult:
        """Return what is known so far."""
        plan = self._plan
        return SimulationResult(
            tuple(self.troubles),
            tuple(self.moved),
            {name: why for name, why in self.unjudged.items() if name not in self.moved},
            tested={name: seen_quantities(act, stood=not self.lying) for name, act in self.acts.items()},
            untested={
                one.controller: untested_joints(plan, one, self.lying)
                for one in plan.tasks
                if one.controller in self.acts
            },
            curves=tuple(self.curves),
            seconds=time.process_time() - self._began,
            left_to_others=tuple(task.controller for task in plan.tasks if set(task.joints) & set(self.stiff_joints)),
            times=dict(self.times),
        )

    def run(self, seen: Callable[[SimulationResult], None] = lambda _: None) -> None:
        """Simulate the whole plan; an explosion ends it."""
        for task in self._plan.tasks:
            self.unjudged[task.controller] = "not simulated: the robot did not settle"
        try:
            if not self._settled():
                return
            given = {user_task.controller: user_task for user_task in self._plan.user_tasks}
            usual = [task for task in self._plan.tasks if task.controller not in given]
            own = [[task] for task in self._plan.tasks if task.controller in given]
            for group in (*groups_of(usual, self._plan.mechanism, fixed=self._plan.fixed), *own):
                began, known = time.process_time(), len(self.troubles)
                self._run([task for task in group if self._can_run(task)], given.get(group[0].controller))
                if len(self.troubles) > known:
                    self._restore()
                took = (time.process_time() - began) / len(group)
                self.times |= {task.controller: took for task in group}
                seen(self.result())
            self._together()
            self._mimics()
        except OutOfTime:
            done, everyone = sum(task.controller in self.acts for task in self._plan.tasks), len(self._plan.tasks)
            self._leave(f"not tested: too slow: {done} of {everyone} controllers tested in {self._plan.budget:g} s")
        except Exploded:
            self._leave("not simulated: the simulation exploded")
            if not any(trouble.code == simulation_explodes.code for trouble in self.troubles):
                self.troubles.append(trouble_of(simulation_explodes, ROBOT, when=""))
        except Tipped:
            self._leave("not simulated: the robot tipped over")

    def _leave(self, why: str) -> None:
        """Note why the controllers that were not tested so far are left."""
        self.unjudged |= {task.controller: why for task in self._plan.tasks if task.controller not in self.acts}

    # -- at rest -----------------------------------------------------------------------------------------------------

    def _settled(self) -> bool:
        for hinge in self._simulation.mechanism.movable:
            free = not self._plan.fixed and hinge.type == "continuous" and hinge.name not in self._simulation.claimed
            if hinge.name in self.wheel_joints:
                self._engine.at_velocity(hinge.name, 0.0, FREELY)
            elif not free:
                hold(self._engine, hinge, hinge.start)
        self._simulation.run_for(SETTLING)
        if self._plan.fixed:
            return True
        standing = self._engine.base_pose()
        tipped = max(abs(standing.roll), abs(standing.pitch)) > TIPPED
        touching = self._engine.touching()
        wheels = dict.fromkeys(wheels_of_drives(self._plan.tasks))
        lifted = [name for name in wheels if self._hinges[name].child not in touching and name not in self._suspended]
        if self._plan.shapeless and (tipped or lifted):
            for task in self._plan.tasks:
                self.unjudged[task.controller] = "not simulated: collision geometry under the robot is missing"
            return False
        if tipped:
            notes = ("check that it has enough wheels or casters",)
            tipping = trouble_of(
                robot_tips_over, ROBOT, None, notes, when=" at spawn", roll=standing.roll, pitch=standing.pitch
            )
            self.troubles.append(tipping)
        for name in lifted:
            owner = next(task.controller for task in self._plan.tasks if name in task.joints)
            on = tuple(link for link in self._simulation.mechanism.bodies if link in touching)
            self.troubles.append(trouble_of(wheel_off_the_ground, f"joint:{name}", owner, joint=name, on=on))
        self._simulation.at_rest = standing
        return not tipped

    # -- controllers -------------------------------------------------------------------------------------------------

    def _can_run(self, task: ControllerTask) -> bool:
        """Whether a controller moves something that can be simulated; if not, it is noted why."""
        if task.family is MotionFamily.STRUCTURAL:
            self.unjudged[task.controller] = f"not simulated: {task.why}"
        elif task.family is MotionFamily.NOTHING:
            self.moved.append(task.controller)
            self.acts[task.controller] = "reads"
        elif why := self._why_not(task):
            self.unjudged[task.controller] = f"not simulated: {why}"
        else:
            return True
        return False

    def _run(self, tasks: Sequence[ControllerTask], user_task: UserTask | None = None) -> None:
        """Test some controllers at the same time, or one with a task of the user."""
        if not tasks:
            return
        try:
            if user_task:
                judged = self._perform(tasks[0], user_task)
            else:
                judged = self._drive(tasks[0]) if tasks[0].base else self._move(tasks)
        except Exploded:
            for name in (task.controller for task in tasks):
                when = f" while controller '{name}' moves its joints"
                self.troubles.append(trouble_of(simulation_explodes, f"controller:{name}", name, when=when))
            raise
        except Tipped as tipped:
            name, act = tasks[0].controller, "drives it" if tasks[0].drive else "moves its joints"
            angles = {"roll": tipped.roll, "pitch": tipped.pitch}
            when = f" while controller '{name}' {act}"
            self.troubles.append(trouble_of(robot_tips_over, ROBOT, name, (), when=when, **angles))
            raise
        for task in tasks if judged else ():
            self.moved.append(task.controller)
            loop = task.family in (MotionFamily.POSITION_PID, MotionFamily.TRAJECTORY) or task.interface == "position"
            own = "performs" if user_task else ""
            of_base = "drives" if task.drive else "rolls" if task.rolling else ""
            self.acts[task.controller] = own or of_base or ("follows" if loop else "moves")

    def _perform(self, task: ControllerTask, user_task: UserTask) -> bool:
        """Let a controller perform a task of the user."""
        result = perform_task(self._simulation, task, user_task)
        self.troubles += result.troubles
        self.curves += result.curves
        return True

    def _drive(self, task: ControllerTask) -> bool:
        """Drive a mobile base."""
        before = self._bases.get(task.drive) if task.drive else None
        if before:
            whose = f"not simulated: controller '{before[0]}' cannot drive the base with its wheels"
            self.unjudged[task.controller] = whose
            return not before[1]
        result = drive_base(self._simulation, task) if task.drive else turn_rollers(self._simulation, task)
        if task.drive:
            self._bases[task.drive] = task.controller, bool(result.why_not or result.troubles)
        self.troubles += result.troubles
        self.curves += result.curves
        if result.why_not:
            self.unjudged[task.controller] = result.why_not
        return not result.why_not

    def _why_not(self, task: ControllerTask) -> str:
        """Why the joints of a controller cannot be simulated, or an empty text."""
        for name in task.joints:
            hinge = self._hinges.get(name)
            if hinge is None:
                return f"'{name}' is not a movable joint"
            if hinge.span[0] == hinge.span[1]:
                return f"joint '{name}' has no range of motion"
            if any(name in joints for joints in self._suspended.values()):
                return f"joint '{name}' is part of a suspension, which the ground moves too"
            if name in self.stiff_joints:
                return f"{self._plan.engine} cannot simulate the damping of joint '{name}'"
        return ""

    def _restore(self) -> None:
        """Put the joints of a robot that stands firmly back to where they began, at rest: what failed may have thrown
        them, and says nothing about the next controllers."""
        if not self._plan.fixed:
            return
        for hinge in self._hinges.values():
            self._engine.place(hinge.name, hinge.start)
            hold(self._engine, hinge, hinge.start)
        self._simulation.run_for(RESTING)

    def _push_each(self, task: ControllerTask, goals: Sequence[Goal]) -> None:
        """Push one joint after the other while the others are held: a push would go through the whole arm."""
        for name in [goal.hinge.name for goal in goals]:
            goal = self._goals([name], self._plan.duration)[0]
            goal = goal._replace(push=self._gentle(goal))
            motion = motion_of(self._engine, task, [goal], PUSHING)
            tracks = self._simulation.tracked([(motion, [goal])], PUSHING)[0]
            self.troubles += joint_troubles(task, [goal], tracks, PUSHING)
            self.curves += self._simulation.curves(task, [goal], tracks)
            hold(self._engine, goal.hinge, self._engine.position(name))
            self._simulation.run_for(RESTING)  # stopping it shakes the others

    def _gentle(self, goal: Goal) -> float:
        """The effort that gives a joint some acceleration against its friction, in N m or N."""
        hinge = goal.hinge
        resisting = hinge.friction + hinge.damping * QUICKLY * PUSHING
        return self._inertias[hinge.name] * QUICKLY + resisting + PART_OF_WEIGHT * abs(goal.weight)

    def _goals(self, names: Sequence[str], duration: float) -> list[Goal]:
        positions = {name: self._engine.position(name) for name in self._simulation.hinges}
        weights = gravity_load(self._simulation.mechanism, positions) if self._plan.fixed else {}
        return [goal_of(self._hinges[name], positions[name], weights.get(name, 0.0), duration) for name in names]

    def _move(self, tasks: Sequence[ControllerTask], part: float = 1.0) -> bool:
        """Move the joints of some controllers that command in the same way, by a part of their usual motion."""
        first = tasks[0]
        loop = first.family in (MotionFamily.POSITION_PID, MotionFamily.VELOCITY_PID) or first.interface != "position"
        seconds = self._plan.duration * (1.0 if loop else 0.5)
        goals = [[goal.times(part) for goal in self._goals(task.joints, seconds)] for task in tasks]
        if first.family is MotionFamily.FORWARD and first.interface == "effort":
            self._push_each(first, goals[0])
            return True
        motions = [motion_of(self._engine, task, own, seconds) for task, own in zip(tasks, goals, strict=True)]
        steps = self._simulation.steps
        if not loop:  # a driver updates positions more often than a slow manager
            self._simulation.every(min(steps, MOST_STEPS))
        tracks = self._simulation.tracked(list(zip(motions, goals, strict=True)), seconds)
        self._simulation.every(steps)
        again: list[ControllerTask] = []
        gently: list[ControllerTask] = []
        for task, own, tracked in zip(tasks, goals, tracks, strict=True):
            troubles = list(joint_troubles(task, own, tracked, seconds))
            for goal in own:
                hold(self._engine, goal.hinge, self._engine.position(goal.hinge.name))
            if troubles and len(tasks) > 1 and is_motor(task):
                again.append(task)
            elif troubles and part == 1.0 and self._plan.fixed and are_overwhelmed(task, own, tracked):
                gently.append(task)
            else:
                self.troubles += troubles
                self.curves += self._simulation.curves(task, own, tracked)
        self._simulation.run_for(RESTING)
        for task in again:  # it moves alone: another one of the group may have disturbed it
            self._move([task])
        for task in gently:  # the usual motion is too much for a motor that may well be strong enough for a small one
            self._restore()
            self._move([task], GENTLY)
        return True

    def _together(self) -> None:
        """Run all loops together: joints that are still when they are moved alone may disturb each other."""
        tasks = [task for task in self._plan.tasks if task.is_loop and task.controller in self.moved]
        tasks = [task for task in tasks if task.family is not MotionFamily.VELOCITY_PID]
        owners: dict[str, tuple[ControllerTask, int]] = {}
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
        motion = PidLoop(self._engine, goals, gains, "effort", lambda goal, _: (goal.end, 0.0))
        tracks = self._simulation.tracked([(motion, goals)], self._plan.duration)[0]
        self.troubles += together_troubles(tasks, goals, tracks)

    def _mimics(self) -> None:
        for hinge in self._hinges.values():
            if self._simulation.follows(hinge) and hinge.mimic:
                apart = abs(self._engine.position(hinge.name) - self._simulation.followed(hinge))
                if apart > within_span(MIMIC, hinge):
                    fields = {"joint": hinge.name, "distance": apart, "unit": hinge.unit, "leader": hinge.mimic[0]}
                    self.troubles.append(trouble_of(mimic_not_kept, f"joint:{hinge.name}", None, (), **fields))
