"""What the rules on claims share: what each distro's controller manager makes of a project, and where claims stand."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from urdfctl.catalog.distros import in_words as distros_in_words
from urdfctl.control.claims import Claim
from urdfctl.control.hardware import Absence, Kind
from urdfctl.control.names import is_misnamed
from urdfctl.control.session import Configured, Missing, Session, sessions
from urdfctl.memory import once_for_the_last
from urdfctl.model.controllers import Controller
from urdfctl.rule import Finding, Note, Project, Severity
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.source.span import Place

Judge = Callable[[Session, Configured], Iterator[Finding]]


@once_for_the_last
def seen(project: Project) -> tuple[Session, ...]:
    """What each distro makes of a project; nothing where robot or controllers are not all known."""
    robot = whole_robot_in(project)
    if robot is None or not controllers_in(project).complete or not project.complete or project.library:
        return ()
    return tuple(sessions(project))


def of_each_candidate(project: Project, judge: Judge) -> Iterator[Finding]:
    """What a judge finds of each controller that is started, or may be: one finding for a place, an error where all
    distros that know the controller give one, and else with a note that names those that do."""
    found: dict[int, dict[Place, dict[str, Finding]]] = {}
    knowing: dict[int, int] = {}
    for session in seen(project):
        for one in session.candidates:
            controller = id(one.controller)
            knowing[controller] = knowing.get(controller, 0) + (one.type is not None)
            for finding in judge(session, one):
                by_distro = found.setdefault(controller, {}).setdefault(finding.at, {})
                by_distro.setdefault(session.distro, finding)
    for controller, by_place in found.items():
        for by_distro in by_place.values():
            yield _joined(by_distro, knowing[controller])


def _joined(by_distro: dict[str, Finding], distros: int) -> Finding:
    """The newest distro's words for all."""
    *_, last = by_distro.values()
    if len(by_distro) == distros and all(finding.severity is last.severity for finding in by_distro.values()):
        return last
    mildest = min((f.severity or Severity.ERROR for f in by_distro.values()), key=lambda severity: severity.weight)
    if len(by_distro) < distros:
        note = Note(f"this holds for {distros_in_words(by_distro)}")
        mildest = Severity.WARNING if mildest is Severity.ERROR else mildest
        last = last._replace(notes=(*last.notes, note))
    return last._replace(severity=mildest)


def home(controller: Controller) -> Place | None:
    """Where a message on a whole controller stands: at its type, its own key or its section; None where no file has
    it."""
    if controller.type is not None:
        return controller.type.at
    return controller.declared_at or (controller.sections[0].at if controller.sections else None)


def place_of(one: Configured, claim: Claim, *, of_interface: bool = False) -> Place | None:
    """Where what a claim is made of stands: the component's name, or the interface's; else the controller's place."""
    name = claim.interface_parameter if of_interface else claim.parameter
    element = claim.interface_element if of_interface else claim.element
    value = one.controller.parameters.value(name) if name else None
    if value is None:
        return home(one.controller)
    if element is not None and element < len(value.items):
        return value.items[element].at
    return value.at


def severity_of(session: Session, one: Configured, missing: Iterable[Missing]) -> Severity:
    """An error where an interface is surely missing.

    A controller that nobody is known to start may be one of several that a file offers for the choice: where another
    one can have its joints, its faults are no more than worth knowing. Or it is for another variant of the robot, one
    that has a sensor more.
    """
    missing = list(missing)
    known_to_start = session.started is not None
    if not known_to_start and _has_alternative(session, one):
        return Severity.INFO
    sure = all(each.absence is Absence.SURE for each in missing)
    hardware = session.hardware
    there = all(hardware.has(each.claim.component) or each.claim.component in hardware.joints for each in missing)
    external = one.type is None or one.type.external
    return Severity.ERROR if sure and not external and (there or known_to_start) else Severity.WARNING


def _has_alternative(session: Session, one: Configured) -> bool:
    namespace, wanted = one.controller.namespace, {claim.component for claim in one.claims.command}
    return any(
        claim.component in wanted
        for other in session.controllers
        if not other.missing and other is not one and other.controller.namespace == namespace
        for claim in other.claims.command
    )


def missing_of(session: Session, one: Configured, kind: Kind) -> list[Missing]:
    """What a controller claims in vain, without names that are none of the robot's: they are a fault of the name."""
    return [each for each in one.missing if each.kind is kind and not is_misnamed(each.claim, session.hardware)]


def offered_by(session: Session, kind: Kind, component: str) -> str:
    """What hardware offers of a component, in words: `position, velocity`."""
    return ", ".join(dict.fromkeys(offer.interface for offer in session.hardware.of(kind, component)))
