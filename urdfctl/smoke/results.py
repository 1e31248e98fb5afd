"""The results of a smoke test: a verdict on each controller of a robot, and the findings before they have a place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum
from typing import Any

from urdfctl.fault import FaultWithMessage, Stage
from urdfctl.lint.results import TargetResult
from urdfctl.startup.records import NamedTuple

ROBOT = "robot"
"""The subject of a finding about the whole robot."""


class Verdict(Enum):
    """The verdict on a controller. It passes only if it moved its joints, or commands nothing."""

    PASSED = "passed"
    FAILED = "failed"
    WARNED = "warned"
    SKIPPED = "skipped"


class ControllerResult(NamedTuple):
    """The result of one controller.

    stage: the one at which it failed, or else the last one that it passed.
    reason: why it has its verdict, or empty.
    tested: what it was seen to do in an engine.
    untested: what was not modelled, by name, with the reason.
    blocked_by: what the fault is in if it is not this controller.
    by_distro: the verdict in each possible distro, if they differ.
    seconds: the processor time of its motions.
    """

    name: str
    type: str | None
    verdict: Verdict
    stage: Stage
    reason: str = ""
    tested: tuple[str, ...] = ()
    untested: Mapping[str, str] = {}
    blocked_by: str = ""
    by_distro: Mapping[str, str] = {}
    seconds: float = 0.0

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> ControllerResult:
        """Return the result that `to_json` made plain data of."""
        values = {"verdict": Verdict(data["verdict"]), "stage": Stage(data["stage"]), "tested": tuple(data["tested"])}
        return cls(**{**data, **values})

    def to_json(self) -> dict[str, Any]:
        """Return the result as plain data."""
        return {**self._asdict(), "verdict": self.verdict.value, "stage": self.stage.value}


class Trouble(NamedTuple):
    """A finding before it has a place in a file.

    `subject` is `controller:NAME`, `gain:CONTROLLER/PARAMETER`, `joint:NAME`, `link:NAME`, `lint:...` (where lint
    reports an error) or ROBOT.
    `controller` is the name of the controller whose verdict it changes, or None.
    `doubt` is why an error is only a warning, as the hardware may move the joint in another way, or empty.
    `seen` is the code of what only one of several engines sees, where the finding is that they disagree, or empty.
    """

    code: str
    subject: str
    message: str
    controller: str | None = None
    notes: tuple[str, ...] = ()
    doubt: str = ""
    seen: str = ""

    @classmethod
    def from_json(cls, data: list[Any]) -> Trouble:
        """Return the trouble that a list of plain data holds."""
        code, subject, message, controller, notes, doubt, seen = data
        return cls(code, subject, message, controller, tuple(notes), doubt=doubt, seen=seen)


def trouble_of(
    fault: FaultWithMessage, subject: str, controller: str | None = None, notes: tuple[str, ...] = (), **facts: object
) -> Trouble:
    """Return a finding of the smoke test, with the message that the fault makes of the facts and the controller."""
    if "controller" in fault.facts:
        facts["controller"] = controller
    return Trouble(fault.code, subject, fault.message(**facts), controller, notes)


class Curve(NamedTuple):
    """The commanded and the measured motion of one joint over seconds.

    commanded, measured: in rad or m, and rad/s or m/s for velocities.
    efforts: those of its motor, in per cent of its limit; empty if it has none.
    band: between which values it must end; None if there is none, as the limits.
    limits: its own limits in the quantity.
    unit: that of the values.
    """

    controller: str
    joint: str
    quantity: str
    seconds: tuple[float, ...]
    commanded: tuple[float, ...]
    measured: tuple[float, ...]
    efforts: tuple[float, ...] = ()
    band: tuple[float, float] | None = None
    limits: tuple[float, float] | None = None
    unit: str = "rad"

    @classmethod
    def from_json(cls, data: list[Any]) -> Curve:
        """Return the curve that a list of plain data holds."""
        fields: list[Any] = [tuple(field) if isinstance(field, list) else field for field in data]
        return cls(*fields)


class RobotResult(NamedTuple):
    """The result of the smoke test of one robot.

    linted: what was linted, with the findings of the smoke test instead of those of lint.
    controllers: their results.
    distro: the one whose controller manager was modelled.
    engine: None if nothing was simulated.
    seconds: the processor time that the simulation took.
    curves: the motions of joints.
    part_of: the link of another file on which a description hangs that is not a robot.
    interrupted: whether Ctrl-C ended the run before all was tested.
    paired: whether the launch file loads no robot, and this is the only one with the joints of its controllers.
    needs: what is not here or not given of what the launch file includes, or of its robot, and what adds it.
    robotless: why a launch file starts no robot; empty if it starts one.
    movers: the plugins of a simulator that move a robot without controllers, in words; empty if there are none.
    """

    linted: TargetResult
    controllers: tuple[ControllerResult, ...] = ()
    distro: str | None = None
    engine: str | None = None
    seconds: float = 0.0
    curves: tuple[Curve, ...] = ()
    part_of: str = ""
    interrupted: bool = False
    paired: bool = False
    needs: str = ""
    robotless: str = ""
    movers: str = ""

    def without(self, hidden: Sequence[str]) -> RobotResult:
        """Return the result in which no controller fails for a finding that is hidden: it is warned instead."""

        def shown(result: ControllerResult) -> ControllerResult:
            known = result.reason and any(message.endswith(result.reason) for message in hidden)
            if result.verdict is not Verdict.FAILED or not known:
                return result
            return result._replace(verdict=Verdict.WARNED, reason=f"hidden finding: {result.reason}")

        return self._replace(controllers=tuple(map(shown, self.controllers))) if hidden else self

    def count(self, verdict: Verdict) -> int:
        """Return the number of controllers with a verdict."""
        return sum(result.verdict is verdict for result in self.controllers)
