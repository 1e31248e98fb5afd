"""The result of a smoke test of one robot: a verdict on each controller, and the findings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum

from urdfctl.lint.results import TargetResult
from urdfctl.rule import Rule, Stage
from urdfctl.startup.hints import Any
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

    `stage` is the one at which it failed, or else the last one that it passed. `tested` holds what it was seen to do in
    an engine; `untested` what was not modelled, by name, with the reason. `blocked_by` names what the fault is in if it
    is not this controller. `by_distro` holds the verdict in each possible distro if they differ. `seconds` is the
    processor time of its motions.
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

    `subject` is `controller:NAME`, `joint:NAME`, `link:NAME`, `lint:...` (where lint reports an error) or ROBOT.
    `controller` is the name of the controller whose verdict it changes, or None.
    """

    code: str
    subject: str
    message: str
    controller: str | None = None
    notes: tuple[str, ...] = ()

    @classmethod
    def from_json(cls, data: list[Any]) -> Trouble:
        """Return the trouble that a list of plain data holds."""
        return cls(data[0], data[1], data[2], data[3], tuple(data[4]))


def trouble_of(
    rule: Rule, subject: str, controller: str | None = None, notes: tuple[str, ...] = (), **fields: object
) -> Trouble:
    """Return a finding of a smoke rule; its message is the rule's, with the controller and the fields filled in."""
    message = rule.message.format(controller=controller, **fields)
    return Trouble(rule.code, subject, message, controller, notes)


class Curve(NamedTuple):
    """The commanded and the measured motion of one joint, in rad or m (velocities: rad/s or m/s), over seconds.

    `efforts` are those of its motor, in per cent of its limit; empty if it has none. `band` holds between which values
    it must end, and `limits` its own limits in the quantity; each is None if there is none. `unit` is that of the
    values.
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


class Smoked(NamedTuple):
    """The smoke test of one robot.

    `linted` holds the findings of the smoke test instead of those of lint. `distro` is the one whose controller manager
    was modelled. `engine` is None if nothing was simulated, and `seconds` is how long the simulation took. `part_of` is
    the link of another file on which a description hangs that is not a robot. `interrupted`: Ctrl-C ended the run
    before all was tested. `paired`: the launch file loads no robot, and this is the only one with the joints of its
    controllers.
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

    def without(self, hidden: Sequence[str]) -> Smoked:
        """Return the test in which no controller fails for a finding that is hidden: it is warned instead."""

        def shown(result: ControllerResult) -> ControllerResult:
            known = result.reason and any(message.endswith(result.reason) for message in hidden)
            if result.verdict is not Verdict.FAILED or not known:
                return result
            return result._replace(verdict=Verdict.WARNED, reason=f"hidden finding: {result.reason}")

        return self._replace(controllers=tuple(map(shown, self.controllers))) if hidden else self

    def count(self, verdict: Verdict) -> int:
        """Return the number of controllers with a verdict."""
        return sum(result.verdict is verdict for result in self.controllers)
