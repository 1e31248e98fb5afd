"""Runs the rules over one project, and joins what several projects of a run gave."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence

from urdfctl.catalog.distros import in_words
from urdfctl.diagnostic import Diagnostic, Finding, Location, Note, Remark, Severity, diagnosed, located
from urdfctl.errors import UserError
from urdfctl.hints import Any
from urdfctl.model.project import Project
from urdfctl.record import NamedTuple
from urdfctl.rule import Rule
from urdfctl.rules import all_rules, rule_of, rules_for
from urdfctl.source.budget import OverBudget
from urdfctl.source.span import Place, SourceSpan, SourceText
from urdfctl.source.suppressions import Suppressed


class Selection(NamedTuple):
    """Which rules are asked: by prefixes of their codes; all where `select` is empty. The longest prefix decides.

    `severities` are those that the user wants, by prefix too; `off` is none.
    """

    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    extend: tuple[str, ...] = ()
    severities: tuple[tuple[str, str], ...] = ()

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Selection:
        """From plain data, in which tuples are lists."""
        severities = tuple((code, severity) for code, severity in data["severities"])
        return cls(tuple(data["select"]), tuple(data["ignore"]), tuple(data["extend"]), severities)

    def admits(self, code: str) -> bool:
        """Whether findings of a code are wanted."""
        wanted = max((len(p) for p in (*self.select, *self.extend) if code.startswith(p)), default=-1)
        if not self.select:
            wanted = max(wanted, 0)
        unwanted = max((len(p) for p in self.ignore if code.startswith(p)), default=-1)
        return wanted > unwanted and self._wanted_severity(code) != "off"

    def severity(self, code: str, own: Severity) -> Severity:
        """The severity of a rule's finding: its own, where the user wants no other."""
        wanted = self._wanted_severity(code)
        return Severity(wanted) if wanted else own

    def _wanted_severity(self, code: str) -> str | None:
        fitting = [(len(prefix), severity) for prefix, severity in self.severities if code.startswith(prefix)]
        return max(fitting)[1] if fitting else None


def checked(made: Selection) -> Selection:
    """A selection, if its prefixes all mean something. UserError where one does not."""
    for prefix in (*made.select, *made.ignore, *made.extend, *(prefix for prefix, _ in made.severities)):
        if not any(rule.code.startswith(prefix) for rule in all_rules()):
            raise UserError(f"no rule's code begins with '{prefix}'; see urdfctl rules")
    return made


class SuppressionUse(NamedTuple):
    """One suppressing comment, and whether it silenced anything in one robot."""

    at: Location
    codes: tuple[str, ...]
    used: bool
    excerpt: str


class Outcome(NamedTuple):
    """What linting one project gave; `crashed` where urdfctl itself was at fault."""

    diagnostics: list[Diagnostic]
    suppressions: list[SuppressionUse]
    crashed: bool = False


class Linted(NamedTuple):
    """What became of one robot. `links` tells how many links it has, None where there is none; `robot` is its name;
    `library` tells that the file holds macros that nothing calls; `files` are those that were read for it,
    `controllers` those that configure controllers, `launch` the launch file that told which belong together,
    `arguments` what the description was given."""

    path: str
    ros: int | None
    distro: str | None
    distro_from: str | None
    simulator: str | None
    complete: bool
    library: bool
    robot: str | None
    links: int | None
    files: tuple[str, ...]
    outcome: Outcome
    controllers: tuple[str, ...] = ()
    launch: str | None = None
    arguments: tuple[tuple[str, str], ...] = ()


class Found(NamedTuple):
    """What some rules found; `crashed` where one of them did, which is a finding too."""

    diagnostics: list[Diagnostic]
    crashed: bool


def lint(
    project: Project,
    sources: Sequence[SourceText],
    selection: Selection,
    rules: Iterable[Rule] | None = None,
    reached: Callable[[SourceSpan], bool] = lambda _: True,
) -> Outcome:
    """What the rules find in a project. `reached` tells whether the robot has anything of the part of a source that a
    span lies in."""
    suppressed = Suppressed(list(sources))
    found = found_by(rules_for(project) if rules is None else rules, project, suppressed, selection)
    return outcome_of(found, project, suppressed, selection, reached)


def found_by(rules: Iterable[Rule], project: Project, suppressed: Suppressed, selection: Selection) -> Found:
    """What some rules find in a project and nobody suppresses. Where a rule crashes the others go on."""
    found: list[Diagnostic] = []
    crashed = False
    for rule in rules:
        if not (selection.admits(rule.code) and _applies(rule, project)):
            continue
        try:
            found.extend(
                _diagnostic(rule, project, finding, selection)
                for finding in rule.check(project)
                if not suppressed.covers(rule.code, finding.at)
            )
        except (OverBudget, MemoryError):
            raise
        except Exception as error:  # noqa: BLE001 (one broken rule must not hide what the others find)
            crashed = True
            found.append(_crash(rule, project, error))
    return Found(found, crashed)


def outcome_of(
    found: Found,
    project: Project,
    suppressed: Suppressed,
    selection: Selection,
    reached: Callable[[SourceSpan], bool],
) -> Outcome:
    """What all rules found, with what the suppressing comments were good for."""
    uses = list(_uses(suppressed, _silent(project, selection), reached)) if suppressed.all else []
    return Outcome(found.diagnostics, uses, found.crashed)


def _silent(project: Project, selection: Selection) -> set[str]:
    """The codes of the rules that were not asked, or that could not see the whole robot."""
    asked = [rule for rule in all_rules() if not rule.of_smoke and selection.admits(rule.code)]
    spoke = [rule for rule in asked if _applies(rule, project)]
    return {rule.code for rule in all_rules()} - {rule.code for rule in spoke if project.complete}


def _uses(
    suppressed: Suppressed, silent: Collection[str], reached: Callable[[SourceSpan], bool]
) -> Iterator[SuppressionUse]:
    """What the comments were good for. Of a code it cannot be told where one of its rules kept silent, because it was
    not asked or the robot is not whole; of none where the comment stands in a macro that this robot does not call."""
    for index, item in enumerate(suppressed.all):
        told = [code for code in item.codes if not any(rule.startswith(code) for rule in silent)]
        used = index in suppressed.used or (bool(item.codes) and not told) or not reached(item.span)
        excerpt = item.span.source.line(item.span.source.position(item.span.start).line)
        yield SuppressionUse(located(item.span), tuple(told), used, excerpt)


def _applies(rule: Rule, project: Project) -> bool:
    if (rule.whole_robot and not project.complete) or (project.library and not rule.in_library):
        return False
    return bool(set(rule.distros) & set(project.distros))


def _diagnostic(rule: Rule, project: Project, finding: Finding, selection: Selection) -> Diagnostic:
    holds = [distro for distro in project.distros if distro in rule.distros]
    if project.distro is None and len(holds) < len(project.distros):
        finding = finding._replace(notes=(*finding.notes, Note(f"this holds for {in_words(holds)}")))
    influence = project.influence(finding.at).in_words()
    if influence:
        finding = finding._replace(notes=(*finding.notes, Note(influence)))
    severity = selection.severity(rule.code, finding.severity or rule.severity)
    return diagnosed(rule.code, rule.name, severity, finding)


def _crash(rule: Rule, project: Project, error: Exception) -> Diagnostic:
    import traceback

    where = traceback.extract_tb(error.__traceback__)[-1]
    place = project.robot.at if project.robot else Place(SourceText(project.path, b""), 0, end=0)
    message = (
        f"the rule {rule.code} {rule.name} crashed: {type(error).__name__}: {error} ({where.name}, line {where.lineno})"
    )
    finding = Finding(place, message, notes=(Note("this is a fault of urdfctl: please report it with this robot"),))
    crashed = rule_of("UC000")
    return diagnosed(crashed.code, crashed.name, crashed.severity, finding)


# -- several projects ------------------------------------------------------------------------------------------------


def joined(outcomes: Iterable[Outcome], selection: Selection) -> list[Diagnostic]:
    """The findings of a run in their stable order: one for each fault, however many calls and robots show it."""
    outcomes = list(outcomes)
    found = [outcome.diagnostics for outcome in outcomes]
    return sorted(_merged([*found, _unused(outcomes, selection)]), key=lambda diagnostic: diagnostic.order)


def _merged(found: Iterable[Iterable[Diagnostic]]) -> Iterator[Diagnostic]:
    """What each of several robots shows, as one."""
    groups: dict[tuple[object, ...], list[Diagnostic]] = {}
    alone: dict[tuple[object, ...], dict[str, dict[int, Diagnostic]]] = {}
    for robot, diagnostics in enumerate(found):
        repeats: Counter[tuple[object, ...]] = Counter()
        for diagnostic in diagnostics:
            place = diagnostic.code, diagnostic.at.file, diagnostic.at.start, diagnostic.at.end
            if not diagnostic.in_macro:
                alone.setdefault(place, {}).setdefault(diagnostic.message, {})[robot] = diagnostic
                continue
            # what one call shows twice at one place are two faults; what each call or robot shows once is one
            way = (*place, diagnostic.at, diagnostic.expanded_from)
            repeats[way] += 1
            groups.setdefault((*place, repeats[way]), []).append(diagnostic)
    for group in groups.values():
        yield _one_of(group)
    for messages in alone.values():
        for fault in _of_variants(messages.values()):
            yield _one_of(list(fault.values()))


def _of_variants(messages: Iterable[dict[int, Diagnostic]]) -> Iterable[dict[int, Diagnostic]]:
    """What robots say at one place, each message with the robots that show it: what no robot shows beside another one
    is the same fault in another variant."""
    faults: list[dict[int, Diagnostic]] = []
    for message in messages:
        same = next((fault for fault in faults if fault.keys().isdisjoint(message)), None)
        if same is None:
            faults.append(message)
        else:
            same.update(message)
    return faults


def _one_of(group: list[Diagnostic]) -> Diagnostic:
    first = min(
        group, key=lambda diagnostic: (-diagnostic.severity.weight, diagnostic.expanded_from, diagnostic.message)
    )
    chains = sorted({chain for diagnostic in group for chain in diagnostic.expanded_from})
    others = sorted({diagnostic.message for diagnostic in group} - {first.message})
    notes = first.notes
    if others:
        shown = "; ".join(others[:3]) + (f"; and {len(others) - 3} more" if len(others) > 3 else "")  # noqa: PLR2004
        notes = (Remark(f"likewise: {shown}"), *notes)
    return first._replace(expanded_from=tuple(chains), notes=notes)


def _unused(outcomes: Iterable[Outcome], selection: Selection) -> Iterator[Diagnostic]:
    uses: dict[Location, SuppressionUse] = {}
    for outcome in outcomes:
        for use in outcome.suppressions:
            known = uses.get(use.at)
            uses[use.at] = use._replace(used=use.used or (known is not None and known.used))
    unused = [use for use in uses.values() if not use.used]
    if unused and selection.admits("UC099"):
        rule = rule_of("UC099")
        for use in unused:
            codes = ", ".join(use.codes) or "no code"
            message = f"nothing to ignore here: no finding of {codes} on this line or the next"
            severity = selection.severity(rule.code, rule.severity)
            yield Diagnostic(rule.code, rule.name, severity, message, use.at, excerpt=use.excerpt)


def worst(diagnostics: Iterable[Diagnostic]) -> Severity | None:
    """The gravest severity among some findings; None where there are none."""
    return max((d.severity for d in diagnostics), key=lambda severity: severity.weight, default=None)
