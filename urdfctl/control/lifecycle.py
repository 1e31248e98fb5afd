"""Take each controller through load, configure and activate, and find the reason if it stops.

ROS 2: controller_manager.cpp. In ROS 1 a controller gets its joints when it is loaded, there is no configure stage, and
activating is called starting.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum

from urdfctl.catalog.distros import generation
from urdfctl.catalog.entries import ParameterRule
from urdfctl.control.chains import Chained, chained_claims, circle, late
from urdfctl.control.claims import Claim
from urdfctl.control.conflicts import claimed_twice, conflicts
from urdfctl.control.hardware.interfaces import Absence, ClaimKind
from urdfctl.control.inactive_hardware import inactive_hardware
from urdfctl.control.needed_interfaces import nothing_to_claim
from urdfctl.control.parameters.rules import breaches
from urdfctl.control.session import Configured, Session
from urdfctl.model.stage import Stage
from urdfctl.startup.records import NamedTuple

STAGES = (Stage.LOAD, Stage.CONFIGURE, Stage.ACTIVATE)
"""The stages at which a controller manager can reject a controller, in order."""


class Reason(Enum):
    """The kind of reason for which a controller stops."""

    TYPE_MISSING = "its type is missing"
    TYPE_UNKNOWN = "its type is unknown"
    PARAMETERS = "its parameters are inconsistent"
    NOT_OFFERED = "no hardware offers a claimed interface"
    NOT_EXPORTED = "another controller does not export a claimed interface"
    NOT_CHAINABLE = "another controller exports no interfaces"
    CLAIMED_TWICE = "it claims an interface twice"
    NOT_ACTIVE = "its hardware is not activated"
    NOTHING_TO_CLAIM = "it has no interface to claim"
    CONFLICT = "another controller has claimed an interface"
    NOT_STARTED = "a controller whose interface it claims is not started first"
    CIRCLE = "controllers claim each other's interfaces in a loop"


AT_LOAD = frozenset({"combinations", "one_group_set", "any_set", "length", "needs"})
"""Kinds of rules on parameters that ROS 2 controllers check on load, when they declare the parameters."""


def stage_of_breach(rule: ParameterRule) -> Stage:
    """Return the stage at which ROS 2 rejects a controller that breaks a rule on its parameters."""
    stage = rule.details.get("stage")
    return Stage(stage) if stage else Stage.LOAD if rule.kind in AT_LOAD else Stage.CONFIGURE


class Stop(NamedTuple):
    """The reason for which a controller stops at a stage."""

    stage: Stage
    reason: Reason
    claim: Claim | None = None
    """The claim that fails."""
    kind: ClaimKind = ClaimKind.COMMAND
    """The kind of that claim."""
    other: Configured | None = None
    """The other controller, which lacks the interface, has claimed it already, or is not started."""
    absence: Absence = Absence.SURE
    """How certain it is; a stop that is only likely may not happen."""
    words: str = ""
    """The message of a broken rule on parameters, or on inactive hardware."""
    ends_manager: bool = False
    """Whether the process of the controller manager ends, and all its controllers with it."""


class Life(NamedTuple):
    """One controller's life."""

    controller: Configured
    stops: tuple[Stop, ...]
    """Everything that stops it, in the order of the stages; the first one ends its life."""

    @property
    def reached(self) -> Stage | None:
        """The last stage that the controller passes; None if it is not loaded."""
        passed = None
        for stage in STAGES:
            if any(stop.stage is stage and stop.absence is Absence.SURE for stop in self.stops):
                break
            passed = stage
        return passed


def lives(session: Session) -> tuple[Life, ...]:
    """Return the lives of the started controllers, in start order; if unknown, those of all controllers."""
    in_conflict: dict[int, list[Stop]] = {}
    for conflict in conflicts(session):
        stop = Stop(Stage.ACTIVATE, Reason.CONFLICT, conflict.claim, other=conflict.first)
        in_conflict.setdefault(id(conflict.second), []).append(stop)
    each_life = []
    for controller in session.candidates:
        stops = [*_stops(session, controller), *in_conflict.get(id(controller), ())]
        each_life.append(Life(controller, tuple(sorted(stops, key=lambda stop: STAGES.index(stop.stage)))))
    return tuple(each_life)


def _stops(session: Session, controller: Configured) -> Iterator[Stop]:
    if controller.type is None:
        given = controller.controller.type is not None
        yield Stop(Stage.LOAD, Reason.TYPE_UNKNOWN if given else Reason.TYPE_MISSING)
        return
    ros1 = generation(session.distro) == 1
    for breach in breaches(controller.type, controller.values):
        if breach.rule.severity == "error":
            words = f"'{breach.parameter}' {breach.message}"
            stage = Stage.LOAD if ros1 else stage_of_breach(breach.rule)
            ends = bool(breach.rule.details.get("ends_manager"))
            yield Stop(stage, Reason.PARAMETERS, words=words, ends_manager=ends)
    for _, claim in claimed_twice(controller, session.distro):
        yield Stop(Stage.ACTIVATE if ros1 else Stage.CONFIGURE, Reason.CLAIMED_TWICE, claim)
    for missing in controller.missing:
        stage = Stage.LOAD if ros1 else Stage.ACTIVATE
        yield Stop(stage, Reason.NOT_OFFERED, missing.claim, missing.kind, absence=missing.absence)
    for inactive in inactive_hardware(session, controller):
        words = f"hardware '{inactive.hardware}' stays {inactive.state}"
        yield Stop(Stage.ACTIVATE, Reason.NOT_ACTIVE, words=words)
    absence = None if ros1 else nothing_to_claim(session, controller)
    if absence is not None:
        yield Stop(Stage(controller.type.needs_interface), Reason.NOTHING_TO_CLAIM, absence=absence)
    yield from _chain_stops(session, controller)


def _chain_stops(session: Session, controller: Configured) -> Iterator[Stop]:
    for chained in chained_claims(session, controller):
        if chained.is_offered is False:
            exports_any = _exports_any(chained.following)
            yield _of_chain(chained, Reason.NOT_EXPORTED if exports_any else Reason.NOT_CHAINABLE)
    if circle(session, controller):
        yield Stop(Stage.ACTIVATE, Reason.CIRCLE)
    elif session.started is not None:
        others = set()
        for chained in late(session, controller):
            if chained.is_offered and chained.following.name not in others:
                others.add(chained.following.name)
                yield _of_chain(chained, Reason.NOT_STARTED)


def _exports_any(controller: Configured) -> bool:
    return bool(controller.exports.reference or controller.exports.state)


def _of_chain(chained: Chained, reason: Reason) -> Stop:
    return Stop(Stage.ACTIVATE, reason, chained.claim, chained.kind, chained.following)
