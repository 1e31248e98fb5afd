"""What goes to the worker of a physics engine, and what comes back."""

from __future__ import annotations

from collections.abc import Mapping

from urdfctl.smoke.assignments import Assignment
from urdfctl.smoke.mechanism import Mechanism
from urdfctl.smoke.results import Curve, Trouble
from urdfctl.smoke.tasks import Task
from urdfctl.startup.hints import Any
from urdfctl.startup.records import NamedTuple

MOTION = 2.0
"""The default time for which each controller moves its joints, in s; half of it for a controller without a loop."""
SHARE = 100
"""A robot with this many joints and controllers may use twice the processor time of a small one."""
BUDGET = 30.0
"""The default processor time of an engine for one robot, in s."""


class Plan(NamedTuple):
    """The input of an engine's worker.

    `engine` is the name of the engine. `urdf` is the text that the engine loads. `rate` is the update rate of the
    controllers, in Hz. `fixed` is whether the root link is fixed to the world. `shapeless` is whether collision
    geometry was left out. `duration` is the time for which each controller moves, in s. `gui` shows a window. `budget`
    is the processor time that the engine may use, in s; then the remaining controllers are not tested. `standing` is
    the text of the URDF with which a robot that nothing fixes to the world is put on the ground, or empty; `held` is
    why it is held in the air instead. `assignments` holds what the user
    asks controllers to do instead of the usual motion.
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
    budget: float = BUDGET
    standing: str = ""
    held: str = ""
    assignments: tuple[Assignment, ...] = ()

    def within(self, seconds: float) -> Plan:
        """Return the plan with a budget: some seconds of processor time, and more for many joints and controllers."""
        return self._replace(budget=seconds * (1 + (len(self.mechanism.hinges) + len(self.tasks)) / SHARE))

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Plan:
        """Return the plan that plain data holds."""
        mechanism = Mechanism.from_json(data["mechanism"])
        tasks = tuple(map(Task.from_json, data["tasks"]))
        assignments = tuple(map(Assignment.from_json, data["assignments"]))
        return cls(**{**data, "mechanism": mechanism, "tasks": tasks, "assignments": assignments})

    def to_json(self) -> dict[str, Any]:
        """Return the plan as plain data."""
        tasks = [task.to_json() for task in self.tasks]
        return {**self._asdict(), "mechanism": self.mechanism.to_json(), "tasks": tasks}


class Tried(NamedTuple):
    """The result of a simulation.

    `moved` holds the controllers that moved their joints. `unjudged` holds those that could not be judged, with the
    reason. `tested` holds for each controller what it was seen to do, and `untested` what was not modelled, with the
    reason. `seconds` is the processor time that it took.
    `refused` is why the engine rejects the robot, or empty. `left_to_others` holds the controllers that another engine
    can judge, but this one cannot. `times` holds the processor time of each controller's motions, in s.
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
    def from_json(cls, data: dict[str, Any]) -> Tried:
        """Return the result that plain data holds."""
        troubles = [Trouble.from_json(fields) for fields in data["troubles"]]
        curves = [Curve.from_json(fields) for fields in data["curves"]]
        tested = {name: tuple(acts) for name, acts in data["tested"].items()}
        lists = {name: tuple(data[name]) for name in ("moved", "left_to_others")}
        return cls(**{**data, **lists, "troubles": tuple(troubles), "curves": tuple(curves), "tested": tested})
