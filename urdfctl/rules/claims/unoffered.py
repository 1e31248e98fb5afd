"""What to say of interfaces that a controller claims and the hardware does not offer."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.claims import Claim
from urdfctl.control.hardware import Kind
from urdfctl.control.session import Configured, Missing, Session
from urdfctl.rule import Finding, Note
from urdfctl.rules.claims.common import home, missing_of, offered_by, place_of, severity_of
from urdfctl.rules.common import in_words
from urdfctl.suggest import nearest


def unoffered(session: Session, one: Configured, kind: Kind) -> Iterator[Finding]:
    """A finding for each interface that no component of a controller offers, and for each other one that some lack."""
    by_interface: dict[str, list[Missing]] = {}
    for missing in missing_of(session, one, kind):
        if not (kind is Kind.STATE and _is_told(session, one, missing.claim)):
            by_interface.setdefault(missing.claim.interface, []).append(missing)
    for interface, found in by_interface.items():
        wanted = [claim for claim in one.claimed(kind) if claim.interface == interface]
        known = all(session.hardware.has(missing.claim.component) for missing in found)
        if len(found) == len(wanted) > 1 and known:
            yield from _finding(session, one, kind, found)
        else:
            for missing in found:
                yield from _finding(session, one, kind, [missing])


def _is_told(session: Session, one: Configured, claim: Claim) -> bool:
    """Whether the same component is missing as a whole, and was told for its command interfaces."""
    return not session.hardware.has(claim.component) and claim.component in {c.component for c in one.claims.command}


def _finding(session: Session, one: Configured, kind: Kind, missing: list[Missing]) -> Iterator[Finding]:
    claims = [each.claim for each in missing]
    at = place_of(one, claims[0], of_interface=len(claims) > 1)
    if at is not None:
        notes = tuple(_notes(session, one, kind, claims, at))
        severity = severity_of(session, one, missing)
        yield Finding(at, _message(session, one, kind, claims), notes, severity=severity)


def _message(session: Session, one: Configured, kind: Kind, claims: list[Claim]) -> str:
    claim, hardware = claims[0], session.hardware
    what = f"'{claim.interface}' {kind.value} interface for controller '{one.name}'"
    if not hardware.has(claim.component):
        right = nearest(claim.component, hardware.offers(kind))
        meant = f"; did you mean '{right}'?" if right else ""
        return f"no hardware offers anything of '{claim.component}', and so no {what}{meant}"
    verb = "exports" if len(claims) == 1 else "export"
    names_of = in_words([one_claim.component for one_claim in claims])
    offered = offered_by(session, kind, claim.component)
    whose = "its hardware exports" if len(claims) == 1 else f"the hardware of '{claim.component}' exports"
    if offered:
        return f"{names_of} {verb} no {what}; {whose}: {offered}"
    states = offered_by(session, Kind.STATE, claim.component)
    only = f"; {whose} no more than the states: {states}" if states and kind is Kind.COMMAND else f"; {whose} none"
    return f"{names_of} {verb} no {what}{only}"


def _notes(session: Session, one: Configured, kind: Kind, claims: list[Claim], at: object) -> Iterator[Note]:
    claim, hardware = claims[0], session.hardware
    offers = hardware.of(kind, claim.component) or hardware.of(Kind.STATE, claim.component)
    if offers:
        yield Note(f"what the hardware exports of '{claim.component}' stands here", offers[0].at)
    type_at = home(one.controller)
    if claim.interface_parameter is None and one.type is not None and type_at is not at:
        yield Note(f"controllers of type '{one.type.type}' claim '{claim.interface}' of each of them", type_at)
    if hardware.open and claim.component not in hardware.exact:
        yield Note("a driver may export more than its description says; of this one it is not known")
