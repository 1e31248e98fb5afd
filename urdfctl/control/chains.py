"""Controllers that claim the interfaces of other controllers: who needs whom, in which order, and in circles.

controller_manager.cpp: what stands before the first slash of an interface's name is looked up among the controllers
before the hardware is asked; so a controller named like a joint hides the joint. From humble on for command interfaces,
from jazzy on for state interfaces too.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.claims import Claim
from urdfctl.control.hardware import Kind
from urdfctl.control.session import CHAINING, Configured, Session, before_slash
from urdfctl.record import NamedTuple


class Chained(NamedTuple):
    """A claim of a controller (`preceding`) to an interface of another one (`following`)."""

    preceding: Configured
    kind: Kind
    claim: Claim
    following: Configured

    @property
    def is_offered(self) -> bool | None:
        """Whether the other exports it; None where that is not known."""
        exports = self.following.exports
        offered = exports.reference if self.kind is Kind.COMMAND else exports.state
        if any(one.name == self.claim.name for one in offered):
            return True
        return False if self.following.type is not None and exports.complete else None


def chained_claims(session: Session, controller: Configured) -> Iterator[Chained]:
    """The claims of a controller to what others of its manager export."""
    for kind in Kind:
        for claim in controller.claimed(kind) if session.distro in CHAINING[kind] else ():
            following = session.named(before_slash(claim), controller)
            if following is not None and not claim.best_effort:
                yield Chained(controller, kind, claim, following)


def circle(session: Session, controller: Configured) -> tuple[Configured, ...]:
    """The controllers, from this one on, each of which claims what the next one exports, and the last what this one
    does; none where there is no such circle."""
    pending: list[tuple[Configured, ...]] = [(controller,)]
    seen: set[str] = set()
    while pending:
        way = pending.pop()
        for chained in chained_claims(session, way[-1]):
            following = chained.following
            if following is controller:
                return way
            if chained.kind is Kind.COMMAND and following.name not in seen:
                seen.add(following.name)
                pending.append((*way, following))
    return ()


def late(session: Session, controller: Configured) -> Iterator[Chained]:
    """The claims of a started controller to what is started after it, where the order is known, or not at all."""
    started = session.started or ()
    before = started[: started.index(controller)] if session.in_order and controller in started else started
    for chained in chained_claims(session, controller):
        if chained.kind is Kind.COMMAND and chained.following not in (*before, controller):
            yield chained
