"""The diagnostics of a smoke test: its findings, each at the line of a controller, a joint, a link or the robot."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType

from urdfctl.diagnostic import Diagnostic, Finding, Remark, Severity, diagnosed
from urdfctl.model.project import Project
from urdfctl.rules import fault_of, faults_found_by
from urdfctl.smoke.results import ROBOT, Trouble
from urdfctl.source.span import Place, SourceText
from urdfctl.source.suppressions import Suppressed

NOTHING: Mapping[str, str] = MappingProxyType({})
PlacedDiagnostics = Mapping[str, Diagnostic]


def subject_places(project: Project, controllers: Mapping[str, Place]) -> Iterator[tuple[str, Place]]:
    """Yield each subject that a finding can have (see `Trouble`) with its place, given those of the controllers."""
    robot = project.robot
    yield ROBOT, robot.at if robot else Place(SourceText(project.path, b""), 0, end=0)
    for name, at in controllers.items():
        yield f"controller:{name}", at
    for joint in robot.joints if robot else ():
        if joint.name:
            yield f"joint:{joint.name}", joint.at
    for link in robot.links if robot else ():
        if link.name:
            yield f"link:{link.name}", link.at


def placed_diagnostics(
    places: Iterable[tuple[str, Place]], wanted: Iterable[str] | None = None
) -> dict[str, Diagnostic]:
    """Return a diagnostic for each subject, or for the wanted ones: at the right place, but still without a message."""
    chosen = None if wanted is None else {*wanted, ROBOT}
    placed: dict[str, Diagnostic] = {}
    for subject, place in places:
        if subject not in placed and (chosen is None or subject in chosen):
            placed[subject] = diagnosed("", "", Severity.ERROR, Finding(place, ""))
    return placed


def suppressed_codes(
    places: Iterable[tuple[str, Place]], causes: Mapping[str, Diagnostic], sources: Sequence[SourceText]
) -> dict[str, list[str]]:
    """Return the codes of faults of the smoke test that comments in the files suppress, by subject.

    places: of the subjects that have one.
    causes: errors of lint, by the subjects of the findings that they cause.
    """
    suppressed = Suppressed(list(sources))
    if not suppressed.all:
        return {}
    by_path = {source.path: source for source in sources}
    everywhere = [
        *places,
        *((name, place) for name, error in causes.items() if (place := _place_of(error, by_path)) is not None),
    ]
    codes_by_subject = {}
    for subject, place in everywhere:
        codes = [fault.code for fault in faults_found_by("smoke") if suppressed.covers(fault.code, place)]
        if codes:
            codes_by_subject[subject] = codes
    return codes_by_subject


def _place_of(error: Diagnostic, sources: Mapping[str, SourceText]) -> Place | None:
    source = sources.get(error.at.file)
    return Place(source, error.at.start, end=error.at.end) if source else None


def diagnostics_of(
    troubles: Iterable[Trouble],
    placed: PlacedDiagnostics,
    suppressed: Mapping[str, Sequence[str]],
    not_started: Mapping[str, str] = NOTHING,
) -> Iterator[Diagnostic]:
    """Yield the findings that are not suppressed, each at its subject; at the robot if the subject has no place.

    placed: from `placed_diagnostics`, for the subjects of the troubles.
    not_started: the controllers that are most likely not started, each with the reason; their errors become warnings
        that give it, as do those that the hardware may not share.
    """
    for trouble in troubles:
        if trouble.code in suppressed.get(trouble.subject, ()):
            continue
        fault = fault_of(trouble.code)
        its_place = placed.get(trouble.subject) or placed.get(f"controller:{trouble.controller}") or placed[ROBOT]
        why = None
        if fault.severity is Severity.ERROR:
            why = trouble.doubt or not_started.get(trouble.controller or "")
        notes = (*trouble.notes, why) if why else trouble.notes
        yield its_place._replace(
            code=fault.code,
            name=fault.name,
            severity=Severity.WARNING if why else fault.severity,
            message=trouble.message,
            notes=tuple(map(Remark, notes)),
            fix=None,
            url=fault.url,
        )


def unexplained(
    troubles: Iterable[Trouble], known: Sequence[Trouble], carried: Mapping[str, Collection[str]] = MappingProxyType({})
) -> list[Trouble]:
    """Return the troubles that no known one about the same controller explains.

    What explains the trouble of a joint is about this joint, or about the whole controller.

    carried: for the joints that fall, the joints that fall with them, whoever moves them; all as subjects.
    """
    falling = {
        (fault.code, subject)
        for trouble in known
        for subject in carried.get(trouble.subject, ())
        for fault in fault_of(trouble.code).explains
    }
    explaining = {
        (trouble.controller, fault.code, subject)
        for trouble in known
        for fault in fault_of(trouble.code).explains
        for subject in ((trouble.subject,) if trouble.subject.startswith("joint:") else ("",))
    }
    by_fault = {(controller, code) for controller, code, _ in explaining}

    def is_explained(trouble: Trouble) -> bool:
        code = trouble.seen or trouble.code
        if not trouble.subject.startswith("joint:"):
            return (trouble.controller, code) in by_fault
        if (code, trouble.subject) in falling:
            return True
        return any((trouble.controller, code, subject) in explaining for subject in ("", trouble.subject))

    return [trouble for trouble in troubles if not is_explained(trouble)]
