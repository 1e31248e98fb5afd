"""What the smoke test of one robot gives: a verdict on each controller, and what was found."""

from __future__ import annotations

from enum import Enum

from urdfctl.hints import Any
from urdfctl.lint import Linted
from urdfctl.record import NamedTuple


class Verdict(Enum):
    """What became of a controller. Only one that moved what it commands, or commands nothing, has passed."""

    PASSED = "passed"
    FAILED = "failed"
    WARNED = "warned"
    SKIPPED = "skipped"


class Step(Enum):
    """The steps of a controller's life, in their order. In ROS 1 nothing is configured, and activating is starting."""

    LOAD = "load"
    CONFIGURE = "configure"
    ACTIVATE = "activate"
    MOVE = "move"
    DEACTIVATE = "deactivate"


STEPS = tuple(Step)


class ControllerResult(NamedTuple):
    """What became of one controller: the step that it failed at, or the last one that it passed, and why."""

    name: str
    type: str | None
    verdict: Verdict
    stage: Step
    reason: str = ""

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> ControllerResult:
        """From plain data."""
        return cls(data["name"], data["type"], Verdict(data["verdict"]), Step(data["stage"]), data["reason"])

    def to_json(self) -> dict[str, Any]:
        """As plain data."""
        return {**self._asdict(), "verdict": self.verdict.value, "stage": self.stage.value}


class Trouble(NamedTuple):
    """Something to be told: the rule's code, and its `subject`: a `controller:NAME`, `joint:NAME` or `link:NAME`, or
    nothing where it is the whole robot. `controller` is the one whose verdict it changes, None where it is nobody's."""

    code: str
    subject: str
    message: str
    controller: str | None = None
    notes: tuple[str, ...] = ()

    @classmethod
    def from_json(cls, data: list[Any]) -> Trouble:
        """From plain data."""
        return cls(data[0], data[1], data[2], data[3], tuple(data[4]))


class Curve(NamedTuple):
    """What one joint was told and what it did, in rad or m (rad/s or m/s for a velocity), over seconds."""

    controller: str
    joint: str
    quantity: str
    seconds: tuple[float, ...]
    commanded: tuple[float, ...]
    measured: tuple[float, ...]


class Smoked(NamedTuple):
    """One robot's smoke test: as linted, with the findings of the smoke test in place of lint's; the engine that moved
    it, None where none did, with how long that took, in seconds; and its shape at spawn as line segments (x, y, z)."""

    linted: Linted
    controllers: tuple[ControllerResult, ...] = ()
    engine: str | None = None
    seconds: float = 0.0
    curves: tuple[Curve, ...] = ()
    picture: tuple[tuple[float, ...], ...] = ()

    def count(self, verdict: Verdict) -> int:
        """How many controllers have a verdict."""
        return sum(one.verdict is verdict for one in self.controllers)
