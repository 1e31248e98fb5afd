"""How far each controller gets on its way through load, configure and activate, and what stops it there.

ROS 2: controller_manager.cpp. In ROS 1 a controller takes its joints when it is loaded, there is nothing to configure,
and activating it is what is called starting.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum

from urdfctl.catalog.distros import generation
from urdfctl.control.chains import Chained, chained_claims, circle, late
from urdfctl.control.claims import Claim
from urdfctl.control.conflicts import claimed_twice, conflicts
from urdfctl.control.hardware import Absence, Kind
from urdfctl.control.parameter_rules import breaches
from urdfctl.control.session import Configured, Session
from urdfctl.record import NamedTuple


class Stage(Enum):
    """The steps of a controller's life, in their order."""

    LOAD = "load"
    CONFIGURE = "configure"
    ACTIVATE = "activate"


class Reason(Enum):
    """What stops a controller."""

    TYPE_MISSING = "its type is not given"
    TYPE_UNKNOWN = "its type is not known"
    PARAMETERS = "its parameters do not fit together"
    NOT_OFFERED = "an interface is not offered"
    NOT_EXPORTED = "a controller does not export an interface"
    NOT_CHAINABLE = "a controller exports nothing at all"
    CLAIMED_TWICE = "it claims an interface twice"
    CONFLICT = "another controller has claimed an interface"
    NOT_STARTED = "a controller whose interface it claims is not started before"
    CIRCLE = "controllers claim each other's interfaces"


AT_LOAD = frozenset({"combinations", "one_group_set", "any_set", "length", "needs"})
"""The kinds of rules on parameters that controllers of ROS 2 check when they declare the parameters, on load."""


class Stop(NamedTuple):
    """What stops a controller at a stage. Of the `other` controller it needs something, or it has it already. An
    `absence` that is only likely may be none."""

    stage: Stage
    reason: Reason
    claim: Claim | None = None
    kind: Kind = Kind.COMMAND
    other: Configured | None = None
    absence: Absence = Absence.SURE
    words: str = ""


class Life(NamedTuple):
    """One controller's way; the first of the `stops` is where it ends."""

    controller: Configured
    stops: tuple[Stop, ...]

    @property
    def reached(self) -> Stage | None:
        """The last stage that it passes."""
        passed = None
        for stage in Stage:
            if any(stop.stage is stage and stop.absence is Absence.SURE for stop in self.stops):
                break
            passed = stage
        return passed


def lives(session: Session) -> tuple[Life, ...]:
    """The ways of the controllers that are started, in their order; where that is not known, of all that are there."""
    in_conflict: dict[int, list[Stop]] = {}
    for one in conflicts(session):
        stop = Stop(Stage.ACTIVATE, Reason.CONFLICT, one.claim, other=one.first)
        in_conflict.setdefault(id(one.second), []).append(stop)
    stages = list(Stage)
    found = []
    for controller in session.candidates:
        stops = [*_stops(session, controller), *in_conflict.get(id(controller), ())]
        found.append(Life(controller, tuple(sorted(stops, key=lambda stop: stages.index(stop.stage)))))
    return tuple(found)


def _stops(session: Session, controller: Configured) -> Iterator[Stop]:
    if controller.type is None:
        given = controller.controller.type is not None
        yield Stop(Stage.LOAD, Reason.TYPE_UNKNOWN if given else Reason.TYPE_MISSING)
        return
    ros1 = generation(session.distro) == 1
    for breach in breaches(controller.type, controller.values):
        if breach.rule.severity == "error":
            words = f"'{breach.parameter}' {breach.message}"
            stage = Stage.LOAD if ros1 or breach.rule.kind in AT_LOAD else Stage.CONFIGURE
            yield Stop(stage, Reason.PARAMETERS, words=words)
    for _, claim in claimed_twice(controller, session.distro):
        yield Stop(Stage.ACTIVATE if ros1 else Stage.CONFIGURE, Reason.CLAIMED_TWICE, claim)
    for one in controller.missing:
        stage = Stage.LOAD if ros1 else Stage.ACTIVATE
        yield Stop(stage, Reason.NOT_OFFERED, one.claim, one.kind, absence=one.absence)
    yield from _chain_stops(session, controller)


def _chain_stops(session: Session, controller: Configured) -> Iterator[Stop]:
    for one in chained_claims(session, controller):
        if one.is_offered is False:
            yield _of_chain(one, Reason.NOT_EXPORTED if _exports_any(one.following) else Reason.NOT_CHAINABLE)
    if circle(session, controller):
        yield Stop(Stage.ACTIVATE, Reason.CIRCLE)
    elif session.started is not None:
        others = set()
        for one in late(session, controller):
            if one.is_offered and one.following.name not in others:
                others.add(one.following.name)
                yield _of_chain(one, Reason.NOT_STARTED)


def _exports_any(controller: Configured) -> bool:
    return bool(controller.exports.reference or controller.exports.state)


def _of_chain(one: Chained, reason: Reason) -> Stop:
    return Stop(Stage.ACTIVATE, reason, one.claim, one.kind, one.following)
