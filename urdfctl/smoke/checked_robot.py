"""A robot after the checks without an engine, as its first worker returns it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from urdfctl.diagnostic import Diagnostic
from urdfctl.lint.serialising import diagnostic_from_json, diagnostic_to_json, result_from_json, result_to_json
from urdfctl.smoke.results import ControllerResult, RobotResult, Trouble
from urdfctl.smoke.tasks import Misfit
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.smoke.motion import MotionPlan


_TEXTS = ("part_of", "needs", "robotless", "movers")
"""The texts of a result before anything moves."""


class CheckedRobot(NamedTuple):
    """A robot as its first worker returns it.

    result: its result as long as nothing moves.
    plan: the input of an engine; None if nothing should move.
    placed: a diagnostic without a message for each subject that a finding of an engine can have.
    troubles: the findings so far.
    suppressed: the codes that comments suppress, by subject.
    misfits: the user's tasks that do not fit it.
    not_started: the controllers that are most likely not started, each with the reason.
    doubts: the errors of its controllers that are warnings, by controller and code, each with the reason.
    """

    result: RobotResult
    plan: MotionPlan | None
    placed: Mapping[str, Diagnostic] = {}
    troubles: tuple[Trouble, ...] = ()
    suppressed: Mapping[str, Sequence[str]] = {}
    misfits: tuple[Misfit, ...] = ()
    not_started: Mapping[str, str] = {}
    doubts: Mapping[str, Mapping[str, str]] = {}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> CheckedRobot:
        """Return the robot that plain data holds."""
        plan = None
        if data["plan"]:
            from urdfctl.smoke.motion import MotionPlan

            plan = MotionPlan.from_json(data["plan"])
        results = tuple(ControllerResult.from_json(each) for each in data["controllers"])
        linted = result_from_json(data["linted"])
        told = {name: data[name] for name in _TEXTS}
        return cls(
            result=RobotResult(linted, results, data["distro"], **told),
            plan=plan,
            placed={subject: diagnostic_from_json(item) for subject, item in data["placed"].items()},
            troubles=tuple(Trouble.from_json(fields) for fields in data["troubles"]),
            suppressed=data["suppressed"],
            misfits=tuple(Misfit(*misfit) for misfit in data["misfits"]),
            not_started=data["not_started"],
            doubts=data["doubts"],
        )

    def to_json(self) -> dict[str, Any]:
        """Return the robot as plain data."""
        return {
            "linted": result_to_json(self.result.linted),
            "controllers": [each.to_json() for each in self.result.controllers],
            "distro": self.result.distro,
            **{name: getattr(self.result, name) for name in _TEXTS},
            "plan": self.plan.to_json() if self.plan else None,
            "placed": {subject: diagnostic_to_json(item) for subject, item in self.placed.items()},
            "troubles": self.troubles,
            "suppressed": dict(self.suppressed),
            "misfits": self.misfits,
            "not_started": self.not_started,
            "doubts": self.doubts,
        }
