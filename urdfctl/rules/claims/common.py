"""Helpers shared by the rules on claims: sessions of the controller manager by distro, and the places of claims."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from urdfctl.catalog.distros import MAINTAINED, applies_to
from urdfctl.control.claims import Claim
from urdfctl.control.hardware.interfaces import Absence, ClaimKind
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.control.session import Configured, MissingInterface, Session, sessions
from urdfctl.control.unknown_joint_claims import is_misnamed
from urdfctl.model.controllers import Controller
from urdfctl.rule import Finding, Note, Project, Severity
from urdfctl.rules.common import whole_robot_in
from urdfctl.source.span import Place
from urdfctl.startup.per_object import once_for_the_last

Judge = Callable[[Session, Configured], Iterator[Finding]]
"""Yields the findings on one controller in one distro."""


@once_for_the_last
def seen(project: Project) -> tuple[Session, ...]:
    """Return the session of each distro; none if the robot or its controllers are not completely known."""
    robot = whole_robot_in(project)
    if robot is None or not controllers_in(project).complete or not project.complete or project.library:
        return ()
    return tuple(sessions(project))


def of_each_candidate(project: Project, judge: Judge) -> Iterator[Finding]:
    """Yield the findings of a judge on each controller that is or may be started, one finding for each place.

    It is an error only if all distros that know the controller give one. Otherwise a note names the distros that do; if
    neither the newest nor a maintained one is among them, it is only info.
    """
    by_controller: dict[int, dict[Place, dict[str, Finding]]] = {}
    knowing: dict[int, list[str]] = {}
    for session in seen(project):
        for candidate in session.candidates:
            key = id(candidate.controller)
            knowing.setdefault(key, []).extend([session.distro] if candidate.type is not None else [])
            for finding in judge(session, candidate):
                by_distro = by_controller.setdefault(key, {}).setdefault(finding.at, {})
                by_distro.setdefault(session.distro, finding)
    for key, by_place in by_controller.items():
        for by_distro in by_place.values():
            yield _joined(by_distro, knowing[key])


def _joined(by_distro: dict[str, Finding], distros: list[str]) -> Finding:
    """One finding for all distros, in the words of the newest; only info if none that is in use gives it."""
    *_, last = by_distro.values()
    if len(by_distro) == len(distros) and all(finding.severity is last.severity for finding in by_distro.values()):
        return last
    mildest = min((f.severity or Severity.ERROR for f in by_distro.values()), key=lambda severity: severity.weight)
    if len(by_distro) < len(distros):
        note = Note(applies_to(by_distro))
        most = Severity.INFO if by_distro.keys().isdisjoint((distros[-1], *MAINTAINED)) else Severity.WARNING
        mildest = min(mildest, most, key=lambda severity: severity.weight)
        last = last._replace(notes=(*last.notes, note))
    return last._replace(severity=mildest)


def home(controller: Controller) -> Place | None:
    """Return the place for a message on a whole controller: its type, key or section; None if no file has it."""
    if controller.type is not None:
        return controller.type.at
    return controller.declared_at or (controller.sections[0].at if controller.sections else None)


def place_of(controller: Configured, claim: Claim, *, of_interface: bool = False) -> Place | None:
    """Return the place of a claim's component name, or else of the whole controller.

    of_interface: return the place of the interface name instead.
    """
    name = claim.interface_parameter if of_interface else claim.parameter
    element = claim.interface_element if of_interface else claim.element
    value = controller.controller.parameters.value(name) if name else None
    if value is None:
        return home(controller.controller)
    if element is not None and element < len(value.items):
        return value.items[element].at
    return value.at


def severity_of(session: Session, controller: Configured, missing: Iterable[MissingInterface]) -> Severity:
    """Return the severity of missing interfaces: error if they are certainly missing.

    If it is unknown which controllers are started, the file may offer several controllers to choose from. The finding
    is then only info if another controller can command the same joints. Or the controller is for another variant of the
    robot, e.g. with one more sensor.
    """
    missing = list(missing)
    known_to_start = session.started is not None
    if not known_to_start and _has_alternative(session, controller):
        return Severity.INFO
    is_certain = all(each.absence is Absence.SURE for each in missing)
    hardware = session.hardware
    exist = all(hardware.has(each.claim.component) or each.claim.component in hardware.joints for each in missing)
    external = controller.type is None or controller.type.external
    return Severity.ERROR if is_certain and not external and (exist or known_to_start) else Severity.WARNING


def _has_alternative(session: Session, controller: Configured) -> bool:
    namespace = controller.controller.namespace
    wanted = {claim.component for claim in controller.claims.command}
    return any(
        claim.component in wanted
        for other in session.controllers
        if not other.missing and other is not controller and other.controller.namespace == namespace
        for claim in other.claims.command
    )


def missing_of(session: Session, controller: Configured, kind: ClaimKind) -> list[MissingInterface]:
    """Return the claimed interfaces that no hardware offers, except those of unknown joints (reported by other rules)."""
    return [each for each in controller.missing if each.kind is kind and not is_misnamed(each.claim, session.hardware)]


def offered_by(session: Session, kind: ClaimKind, component: str) -> str:
    """Return the interfaces that hardware offers of a component, as text: `position, velocity`."""
    return ", ".join(dict.fromkeys(offer.interface for offer in session.hardware.of(kind, component)))
