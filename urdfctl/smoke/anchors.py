"""Where the findings of the smoke test stand: at a controller's line in its file, at a joint or link, at the robot."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.diagnostic import Diagnostic, Finding, Remark, Severity, diagnosed
from urdfctl.model.project import Project
from urdfctl.rules import rule_of
from urdfctl.smoke.results import Trouble
from urdfctl.source.span import Place, SourceText
from urdfctl.source.suppressions import Suppressed

Anchors = Mapping[str, Diagnostic]
ROBOT = "robot"


def subjects(project: Project) -> Iterator[tuple[str, Place]]:
    """What findings may be about, each with its place."""
    robot = project.robot
    yield ROBOT, robot.at if robot else Place(SourceText(project.path, b""), 0, end=0)
    for controller in project.controllers.controllers if project.controllers else ():
        if controller.declared_at is not None:
            yield f"controller:{controller.name}", controller.declared_at
    for joint in robot.joints if robot else ():
        if joint.name:
            yield f"joint:{joint.name}", joint.at
    for link in robot.links if robot else ():
        if link.name:
            yield f"link:{link.name}", link.at


def anchors_of(
    project: Project, found: Sequence[Diagnostic], wanted: Iterable[str] | None = None
) -> dict[str, Diagnostic]:
    """For each subject, or each of those wanted, a diagnostic that says nothing yet but stands at the right place."""
    chosen = None if wanted is None else {*wanted, ROBOT}
    made = {}
    for subject, place in subjects(project):
        if subject not in made and (chosen is None or subject in chosen):
            made[subject] = diagnosed("", "", Severity.ERROR, Finding(place, ""))
    for one in found:
        made.setdefault(f"lint:{one.code}", one)
    return made


def silenced(project: Project, sources: Sequence[SourceText]) -> dict[str, list[str]]:
    """The codes of the smoke test that comments in the files silence at each subject."""
    suppressed = Suppressed(list(sources))
    if not suppressed.all:
        return {}
    from urdfctl.rules.smoke.family import RULES

    found = {}
    for subject, place in subjects(project):
        codes = [rule.code for rule in RULES if suppressed.covers(rule.code, place)]
        if codes:
            found[subject] = codes
    return found


def diagnostics_of(
    troubles: Iterable[Trouble], anchors: Anchors, silent: Mapping[str, Sequence[str]]
) -> Iterator[Diagnostic]:
    """What is told of the troubles, each where its subject stands; of an unknown one at the robot."""
    for trouble in troubles:
        if trouble.code in silent.get(trouble.subject, ()):
            continue
        rule = rule_of(trouble.code)
        anchor = anchors.get(trouble.subject) or anchors[ROBOT]
        yield anchor._replace(
            code=rule.code,
            name=rule.name,
            severity=rule.severity,
            message=trouble.message,
            notes=tuple(map(Remark, trouble.notes)),
            fix=None,
        )
