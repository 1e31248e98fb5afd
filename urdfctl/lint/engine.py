"""Run the rules on one project."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from functools import lru_cache

from urdfctl.catalog.distros import APPLIES, applies_to
from urdfctl.diagnostic import Diagnostic, Finding, Note, diagnosed, excerpt_at, located
from urdfctl.lint.results import Outcome, SuppressionUse
from urdfctl.lint.selection import Selection
from urdfctl.model.project import Project
from urdfctl.names import forget_comparisons
from urdfctl.rule import Rule
from urdfctl.rules import all_faults, faults_found_by, rules_for
from urdfctl.source.budget import OverBudget
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.source.suppressions import Suppressed


def lint(
    project: Project,
    sources: Sequence[SourceText],
    selection: Selection,
    rules: Iterable[Rule] | None = None,
    reached: Callable[[SourceSpan], bool] = lambda _: True,
) -> Outcome:
    """Return what the rules find in a project. After a rule that crashes, the others still run.

    sources: the texts whose suppression comments apply.
    rules: those of the families that concern the project, if None.
    reached: returns whether the robot includes a source span.
    """
    suppressed = Suppressed(list(sources))
    diagnostics: list[Diagnostic] = []
    crashed = False
    for rule in rules_for(project) if rules is None else rules:
        if not (selection.admits(rule.code) and _applies(rule, project)):
            continue
        forget_comparisons()
        try:
            diagnostics.extend(
                _diagnostic(rule, project, finding, selection)
                for finding in _known(rule.check(project), sources)
                if not suppressed.covers(rule.code, finding.at)
            )
        except (OverBudget, MemoryError):
            raise
        except Exception as error:  # noqa: BLE001 (one broken rule must not hide what the others find)
            crashed = True
            diagnostics.append(_crash(rule, project, error))
    uses = list(_uses(suppressed, _silent_codes(project, selection), reached)) if suppressed.all else []
    return Outcome(diagnostics, uses, crashed)


def _known(findings: Iterable[Finding], sources: Sequence[SourceText]) -> Iterator[Finding]:
    """The findings that do not depend on an unknown value, with names as they are written where part is unknown."""
    for finding in findings:
        if UNKNOWN not in finding.message:
            yield finding
            continue
        from urdfctl.lint.findings.unknown_names import as_written

        written = as_written(finding, sources)
        if written is not None:
            yield written


def _silent_codes(project: Project, selection: Selection) -> set[str]:
    """Return the codes of faults that nothing looked for, or not in the whole robot."""
    heard: set[str] = set()
    if project.complete:
        selected = (fault for fault in faults_found_by("lint") if selection.admits(fault.code))
        heard.update(fault.code for fault in selected if not isinstance(fault, Rule) or _applies(fault, project))
    return {fault.code for fault in all_faults()} - heard


def _uses(
    suppressed: Suppressed, silent: Collection[str], reached: Callable[[SourceSpan], bool]
) -> Iterator[SuppressionUse]:
    """Yield each suppression comment with whether it was used.

    It counts as used if that is unknown: not all its rules ran, or it is in a macro that this robot does not call.
    """
    unjudged = {code[:length] for code in silent for length in range(1, len(code) + 1)}
    for index, item in enumerate(suppressed.all):
        judged = [code for code in item.codes if code not in unjudged]
        used = index in suppressed.used or (bool(item.codes) and not judged) or not reached(item.span)
        yield SuppressionUse(located(item.span), tuple(judged), used, *excerpt_at(item.span))


def _applies(rule: Rule, project: Project) -> bool:
    if (rule.whole_robot and not project.complete) or (project.library and not rule.in_library):
        return False
    return _have_one_in_common(rule.distros, project.distros)


@lru_cache(256)
def _have_one_in_common(distros: tuple[str, ...], others: tuple[str, ...]) -> bool:
    return not set(distros).isdisjoint(others)


def _diagnostic(rule: Rule, project: Project, finding: Finding, selection: Selection) -> Diagnostic:
    applicable = [distro for distro in project.distros if distro in rule.distros]
    is_noted = any(note.message.startswith(APPLIES) for note in finding.notes)
    if project.distro is None and len(applicable) < len(project.distros) and not is_noted:
        finding = finding._replace(notes=(*finding.notes, Note(applies_to(applicable))))
    influence = project.influence(finding.at).in_words()
    if influence:
        finding = finding._replace(notes=(*finding.notes, Note(influence)))
    severity = selection.severity(rule.code, finding.severity or rule.severity)
    return diagnosed(rule.code, rule.name, severity, finding, rule.url)


def _crash(rule: Rule, project: Project, error: Exception) -> Diagnostic:
    import traceback

    from urdfctl.rules.reading.rule_crashed import rule_crashed

    where = traceback.extract_tb(error.__traceback__)[-1]
    place = project.robot.at if project.robot else Place(SourceText(project.path, b""), 0, end=0)
    why = f"{type(error).__name__}: {error} ({where.name}, line {where.lineno})"
    message = rule_crashed.message(f"rule {rule.code} {rule.name}", why)
    finding = Finding(place, message, notes=(Note("this is a bug in urdfctl: please report it with this robot"),))
    return diagnosed(rule_crashed.code, rule_crashed.name, rule_crashed.severity, finding, rule_crashed.url)
