"""What to say of interfaces that a controller claims and the hardware does not offer."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.claims import Claim
from urdfctl.control.hardware import Kind
from urdfctl.control.life import Stop
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note
from urdfctl.rules.claims.common import home, missing_of, offered_by, place_of, severity_of
from urdfctl.rules.common import in_words
from urdfctl.suggest import nearest


def unoffered(session: Session, one: Configured, kind: Kind) -> Iterator[Finding]:
    """A finding for each interface that no component of a controller offers, and for each other one that some lack."""
    stops = missing_of(session, one, kind)
    by_interface: dict[str, list[Stop]] = {}
    for stop in stops:
        if stop.claim is not None and not (kind is Kind.STATE and _is_told(session, one, stop.claim)):
            by_interface.setdefault(stop.claim.interface, []).append(stop)
    claims = one.claims.command if kind is Kind.COMMAND else one.claims.state
    for interface, found in by_interface.items():
        wanted = [claim for claim in claims if claim.interface == interface]
        if len(found) == len(wanted) > 1 and _are_all_known(session, found):
            yield from _finding(session, one, kind, found)
        else:
            for stop in found:
                yield from _finding(session, one, kind, [stop])


def _is_told(session: Session, one: Configured, claim: Claim) -> bool:
    """Whether the same component is missing as a whole, and was told for its command interfaces."""
    return not session.hardware.has(claim.component) and claim.component in {c.component for c in one.claims.command}


def _are_all_known(session: Session, found: list[Stop]) -> bool:
    return all(stop.claim is not None and session.hardware.has(stop.claim.component) for stop in found)


def _finding(session: Session, one: Configured, kind: Kind, stops: list[Stop]) -> Iterator[Finding]:
    claims = [stop.claim for stop in stops if stop.claim is not None]
    at = place_of(one, claims[0], of_interface=len(claims) > 1)
    if at is None:
        return
    notes = tuple(_notes(session, one, kind, claims, at))
    severity = severity_of(session, one, [stop.absence for stop in stops])
    yield Finding(at, _message(session, one, kind, claims), notes, severity=severity)


def _message(session: Session, one: Configured, kind: Kind, claims: list[Claim]) -> str:
    claim, hardware = claims[0], session.hardware
    what = f"'{claim.interface}' {kind.value} interface for controller '{one.name}'"
    if not hardware.has(claim.component):
        names = {offer.component for offer in hardware.offers(kind)}
        right = nearest(claim.component, names)
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
        yield Note(f"a '{one.type.type}' claims '{claim.interface}' of each of them", type_at)
    if hardware.open and claim.component not in hardware.exact:
        yield Note("a driver may export more than its description says; of this one it is not known")
