"""Controllers that are refused because nothing is left for them to claim."""

from __future__ import annotations

from urdfctl.control.claims import Claim
from urdfctl.control.hardware.interfaces import Absence, ClaimKind
from urdfctl.control.session import Configured, Session


def nothing_to_claim(session: Session, controller: Configured) -> Absence | None:
    """Return how certain it is that a controller which needs an interface has none; None if it has one, or needs none.

    Claims that are reported as missing by themselves count as claims.
    """
    kind, hardware = controller.type, session.hardware
    if kind is None or kind.needs_interface is None or not controller.claims.complete or not hardware.known:
        return None
    if hardware.bare:
        return None
    if any(_is_met(session, claim, which) for which in ClaimKind for claim in controller.claimed(which)):
        return None
    if any(
        other.exports.state or not other.exports.complete for other in session.candidates if other is not controller
    ):
        return None  # a chained controller may offer states
    return Absence.LIKELY if hardware.open else Absence.SURE


def _is_met(session: Session, claim: Claim, kind: ClaimKind) -> bool:
    return not claim.best_effort or session.hardware.absence(kind, claim.component, claim.interface) is None
