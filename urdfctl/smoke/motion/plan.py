"""The plan of a robot's motion, which goes to the worker of a physics engine, and the result, which comes back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from urdfctl.smoke.results import Curve, Trouble
from urdfctl.smoke.robot import Mechanism
from urdfctl.smoke.tasks import MOTION, ControllerTask, UserTask
from urdfctl.startup.records import NamedTuple

SHARE = 100
"""A robot with this many joints and controllers may use twice the processor time of a small one."""
BUDGET = 30.0
"""The default processor time of an engine for one robot, in s."""


class MotionPlan(NamedTuple):
    """The input of an engine's worker.

    engine: the name of the engine.
    urdf: the text that the engine loads.
    mechanism: the robot.
    tasks: of the controllers that are tested.
    rate: the update rate of the controllers, in Hz.
    fixed: whether the root link is fixed to the world.
    shapeless: whether collision geometry was left out.
    duration: the time for which each controller moves, in s.
    gui: whether to show a window.
    budget: the processor time that the engine may use, in s; then the remaining controllers are not tested.
    ground_urdf: the text with which a robot that nothing fixes to the world is put on the ground, or empty.
    why_held: why such a robot is held in the air instead, or empty.
    user_tasks: what the user asks controllers to do, instead of the usual motion.
    """

    engine: str
    urdf: str
    mechanism: Mechanism
    tasks: tuple[ControllerTask, ...]
    rate: float
    fixed: bool
    shapeless: bool = False
    duration: float = MOTION
    gui: bool = False
    budget: float = BUDGET
    ground_urdf: str = ""
    why_held: str = ""
    user_tasks: tuple[UserTask, ...] = ()

    def within(self, seconds: float) -> MotionPlan:
        """Return the plan with a budget: some seconds of processor time, and more for many joints and controllers."""
        return self._replace(budget=seconds * (1 + (len(self.mechanism.hinges) + len(self.tasks)) / SHARE))

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> MotionPlan:
        """Return the plan that plain data holds."""
        mechanism = Mechanism.from_json(data["mechanism"])
        tasks = tuple(map(ControllerTask.from_json, data["tasks"]))
        user_tasks = tuple(map(UserTask.from_json, data["user_tasks"]))
        return cls(**{**data, "mechanism": mechanism, "tasks": tasks, "user_tasks": user_tasks})

    def to_json(self) -> dict[str, Any]:
        """Return the plan as plain data."""
        tasks = [task.to_json() for task in self.tasks]
        return {**self._asdict(), "mechanism": self.mechanism.to_json(), "tasks": tasks}


class SimulationResult(NamedTuple):
    """The result of a simulation.

    troubles: what is wrong.
    moved: the controllers that moved their joints.
    unjudged: the controllers that could not be judged, each with the reason.
    tested: what each controller was seen to do.
    untested: what of each controller was not modelled, by name, with the reason.
    curves: the motions of joints.
    seconds: the processor time of the simulation.
    refused: why the engine rejects the robot, or empty.
    left_to_others: the controllers that another engine can judge, but this one cannot.
    times: the processor time of each controller's motions, in s.
    """

    troubles: tuple[Trouble, ...] = ()
    moved: tuple[str, ...] = ()
    unjudged: Mapping[str, str] = {}
    tested: Mapping[str, tuple[str, ...]] = {}
    untested: Mapping[str, Mapping[str, str]] = {}
    curves: tuple[Curve, ...] = ()
    seconds: float = 0.0
    refused: str = ""
    left_to_others: tuple[str, ...] = ()
    times: Mapping[str, float] = {}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> SimulationResult:
        """Return the result that plain data holds."""
        troubles = [Trouble.from_json(fields) for fields in data["troubles"]]
        curves = [Curve.from_json(fields) for fields in data["curves"]]
        tested = {name: tuple(acts) for name, acts in data["tested"].items()}
        lists = {name: tuple(data[name]) for name in ("moved", "left_to_others")}
        return cls(**{**data, **lists, "troubles": tuple(troubles), "curves": tuple(curves), "tested": tested})
