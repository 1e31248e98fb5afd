"""A recording beside what the files expect, and what the checks of it find."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from urdfctl.diagnostic import Severity
from urdfctl.doctor.expectation import Expectation, ExpectedController
from urdfctl.doctor.log import Log
from urdfctl.doctor.recording import RecordedController, RecordedManager, Recording
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.fault import FaultWithMessage


class Ailment(NamedTuple):
    """What is wrong in a running system.

    at: the place in the files, as file:line:column; empty if it is in none.
    """

    code: str
    name: str
    severity: Severity
    message: str
    at: str = ""
    notes: tuple[str, ...] = ()


class Examination(NamedTuple):
    """A recording, and what the files expect: of each robot that the launch file starts, one.

    log: what failed, as the system printed it.
    """

    recording: Recording
    expected: tuple[Expectation, ...]
    log: Log = Log()

    @property
    def managers(self) -> tuple[str, ...]:
        """The full names of the managers that the files expect."""
        return tuple(dict.fromkeys(name for each in self.expected for name in each.managers))

    @property
    def controllers(self) -> tuple[ExpectedController, ...]:
        """The controllers of all managers that the files expect, each once."""
        every = (controller for each in self.expected for controller in each.controllers)
        return tuple({(one.manager, one.name): one for one in every}.values())

    @property
    def is_whole(self) -> bool:
        """Whether everything that is started is known from the files."""
        return all(each.complete for each in self.expected)

    def settings(self, manager: str) -> Mapping[str, Any]:
        """Return the parameters that the files give a manager."""
        return next((each.settings[manager] for each in self.expected if manager in each.settings), {})

    def logged(self, *names: str) -> str:
        """Return what the log says of a controller, component or manager; empty if it says nothing."""
        reason = self.log.of(*names)
        return f"line {reason.line} of the log: {reason.text}" if reason else ""

    def manager(self, name: str) -> RecordedManager:
        """Return a manager as the recording shows it."""
        return self.recording.managers.get(name) or RecordedManager(name, answers=False)

    def running(self, expected: ExpectedController) -> RecordedController | None:
        """Return an expected controller as its manager lists it; None if it does not."""
        return self.manager(expected.manager).controller(expected.name)

    def description_of(self, expected: Expectation) -> str | None:
        """Return the description that is published for an expected robot; None if none is."""
        texts = self.recording.descriptions
        own = texts.get(f"{expected.namespace}/robot_description")
        if own is None and len(self.expected) == 1 and len(texts) == 1:
            [own] = texts.values()
        return own[-1] if own else None


def ailment(fault: FaultWithMessage, at: str = "", notes: Sequence[str] = (), **facts: object) -> Ailment:
    """Return what is wrong, with the message that a fault makes of the facts."""
    return Ailment(
        code=fault.code,
        name=fault.name,
        severity=fault.severity,
        message=fault.message(**facts),
        at=at,
        notes=tuple(notes),
    )
