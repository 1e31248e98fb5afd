"""Findings on interfaces that a controller claims and the hardware does not offer."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.claims import Claim
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import Configured, MissingInterface, Session
from urdfctl.names import nearest
from urdfctl.rule import Finding, Note
from urdfctl.rules.claims.common import home, missing_of, offered_by, place_of, severity_of
from urdfctl.rules.common import in_words


def unoffered(session: Session, controller: Configured, kind: ClaimKind) -> Iterator[Finding]:
    """Yield the findings on a controller's claims of a kind that the hardware does not offer.

    One finding for an interface that all components lack; for another interface one for each component that lacks it.
    """
    by_interface: dict[str, list[MissingInterface]] = {}
    for missing in missing_of(session, controller, kind):
        if not (kind is ClaimKind.STATE and _is_reported_for_command(session, controller, missing.claim)):
            by_interface.setdefault(missing.claim.interface, []).append(missing)
    for interface, of_interface in by_interface.items():
        claimed = [claim for claim in controller.claimed(kind) if claim.interface == interface]
        known = all(session.hardware.has(missing.claim.component) for missing in of_interface)
        if len(of_interface) == len(claimed) > 1 and known:
            yield from _finding(session, controller, kind, of_interface)
        else:
            for missing in of_interface:
                yield from _finding(session, controller, kind, [missing])


def _is_reported_for_command(session: Session, controller: Configured, claim: Claim) -> bool:
    """Whether the whole component is missing, and is reported for its command interfaces."""
    commanded = {command.component for command in controller.claims.command}
    return not session.hardware.has(claim.component) and claim.component in commanded


def _finding(
    session: Session, controller: Configured, kind: ClaimKind, missing: list[MissingInterface]
) -> Iterator[Finding]:
    claims = [each.claim for each in missing]
    at = place_of(controller, claims[0], of_interface=len(claims) > 1)
    if at is not None:
        notes = tuple(_notes(session, controller, kind, claims, at))
        severity = severity_of(session, controller, missing)
        yield Finding(at, _message(session, controller, kind, claims), notes, severity=severity)


def _message(session: Session, controller: Configured, kind: ClaimKind, claims: list[Claim]) -> str:
    claim, hardware = claims[0], session.hardware
    interface = f"'{claim.interface}' {kind.value} interface"
    if not hardware.has(claim.component):
        if claim.component in hardware.joints:
            return (
                f"joint '{claim.component}' is in the robot, but not in <ros2_control>; "
                f"controller '{controller.name}' claims its {interface}"
            )
        others = {other.component for other in controller.claimed(kind)}
        right = nearest(claim.component, [name for name in hardware.offers(kind) if name not in others])
        hint = f"; did you mean '{right}'?" if right else ""
        return f"no hardware exports '{claim.component}'; controller '{controller.name}' claims its {interface}{hint}"
    components = in_words([each.component for each in claims])
    have = "has" if len(claims) == 1 else "have"
    message = f"{components} {have} no {interface}, which controller '{controller.name}' claims"
    exports = "the hardware exports" if len(claims) == 1 else f"the hardware of '{claim.component}' exports"
    offered = offered_by(session, kind, claim.component)
    if offered:
        return f"{message}; {exports}: {offered}"
    states = offered_by(session, ClaimKind.STATE, claim.component)
    return f"{message}; {exports} only state interfaces: {states}" if states else f"{message}; {exports} none"


def _notes(
    session: Session, controller: Configured, kind: ClaimKind, claims: list[Claim], at: object
) -> Iterator[Note]:
    claim, hardware = claims[0], session.hardware
    offers = hardware.of(kind, claim.component) or hardware.of(ClaimKind.STATE, claim.component)
    if offers:
        yield Note(f"interfaces of '{claim.component}' are defined here", offers[0].at)
    type_at = home(controller.controller)
    if claim.interface_parameter is None and controller.type is not None and type_at is not at:
        kind_of_controller = controller.type.type
        yield Note(f"controllers of type '{kind_of_controller}' claim '{claim.interface}' of each component", type_at)
    if hardware.open and claim.component not in hardware.exact:
        yield Note("the driver may export more interfaces than the description lists")
