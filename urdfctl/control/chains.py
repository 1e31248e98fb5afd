"""Controllers that claim the interfaces of other controllers: dependencies, start order and loops.

controller_manager.cpp: the part of an interface's name before the first slash is looked up among the controllers first,
then in the hardware; so a controller with a joint's name hides the joint. From humble on for command interfaces, from
jazzy on for state interfaces too.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.claims import Claim
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import CHAINING, Configured, Session, before_slash
from urdfctl.startup.records import NamedTuple


class Chained(NamedTuple):
    """A claim of a controller to an interface of another controller."""

    preceding: Configured
    """The controller that claims."""
    kind: ClaimKind
    claim: Claim
    following: Configured
    """The controller with the name before the first slash."""

    @property
    def is_offered(self) -> bool | None:
        """Whether the following controller exports the interface; None if unknown."""
        exports = self.following.exports
        offered = exports.reference if self.kind is ClaimKind.COMMAND else exports.state
        if any(export.name == self.claim.name for export in offered):
            return True
        return False if self.following.type is not None and exports.complete else None


def chained_claims(session: Session, controller: Configured) -> Iterator[Chained]:
    """Yield the claims of a controller to interfaces of other controllers of its manager."""
    for kind in ClaimKind:
        for claim in controller.claimed(kind) if session.distro in CHAINING[kind] else ():
            following = session.named(before_slash(claim), controller)
            if following is not None and not claim.best_effort:
                yield Chained(controller, kind, claim, following)


def circle(session: Session, controller: Configured) -> tuple[Configured, ...]:
    """Return the loop of controllers that starts with this one; empty if there is none.

    Each controller claims an interface of the next, and the last one an interface of the first.
    """
    pending: list[tuple[Configured, ...]] = [(controller,)]
    seen: set[str] = set()
    while pending:
        path = pending.pop()
        for chained in chained_claims(session, path[-1]):
            following = chained.following
            if following is controller:
                return path
            if chained.kind is ClaimKind.COMMAND and following.name not in seen:
                seen.add(following.name)
                pending.append((*path, following))
    return ()


def late(session: Session, controller: Configured) -> Iterator[Chained]:
    """Yield the command claims of a started controller to controllers started after it, or not at all.

    If the start order is unknown, only controllers that are not started count, and those that the same spawner starts
    later.
    """
    started = session.started or ()
    later = session.later.get(controller.name, frozenset())
    before = started[: started.index(controller)] if session.in_order and controller in started else started
    for chained in chained_claims(session, controller):
        is_late = chained.following.name in later or chained.following not in (*before, controller)
        if chained.kind is ClaimKind.COMMAND and is_late:
            yield chained
