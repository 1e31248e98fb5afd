"""Merge the diagnostics of several targets: one for each fault, however many calls and robots show it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from urdfctl.diagnostic import Diagnostic, Location, Remark, Severity
from urdfctl.lint.findings.causes import LINKS_OF_RUN, without_consequences
from urdfctl.lint.findings.likeness import difference
from urdfctl.lint.results import Outcome, SuppressionUse, TargetResult
from urdfctl.lint.selection import Selection

_OF_OTHER_ROBOTS = frozenset({"UC156"})
"""Rules about a part that refers to what the robot does not have, and that does no harm."""
_MAX_LIKEWISE = 3
"""How many names of other messages a merged diagnostic lists. Of messages that are not alike, it quotes one."""


def merge(outcomes: Iterable[Outcome], selection: Selection) -> list[Diagnostic]:
    """Return the diagnostics of a run, and its unused suppressions, in the order of a report."""
    outcomes = list(outcomes)
    diagnostics = [without_consequences(outcome.diagnostics) for outcome in outcomes]
    merged = sorted(_merged([*diagnostics, _unused(outcomes, selection)]), key=lambda diagnostic: diagnostic.order)
    return list(without_consequences(merged, LINKS_OF_RUN))


def _merged(targets: Iterable[Iterable[Diagnostic]]) -> Iterator[Diagnostic]:
    in_macros: dict[tuple[object, ...], list[Diagnostic]] = {}
    elsewhere: dict[tuple[object, ...], dict[str, dict[int, Diagnostic]]] = {}
    for target, diagnostics in enumerate(targets):
        repeats: Counter[tuple[object, ...]] = Counter()
        for diagnostic in diagnostics:
            place = diagnostic.code, diagnostic.at.file, diagnostic.at.start, diagnostic.at.end
            if not diagnostic.in_macro:
                elsewhere.setdefault(place, {}).setdefault(diagnostic.message, {})[target] = diagnostic
                continue
            # two in one call at one place are two faults; one in each call or robot is the same fault
            call = (*place, diagnostic.at, diagnostic.expanded_from)
            repeats[call] += 1
            in_macros.setdefault((*place, repeats[call]), []).append(diagnostic)
    for group in in_macros.values():
        yield _one_diagnostic(group)
    for messages in elsewhere.values():
        for fault in _of_variants(messages.values()):
            yield _one_diagnostic(list(fault.values()))


def _of_variants(messages: Iterable[dict[int, Diagnostic]]) -> Iterable[dict[int, Diagnostic]]:
    """Group messages at one place, each given with the targets that show it: two messages that no target shows
    together are the same fault in two variants."""
    faults: list[dict[int, Diagnostic]] = []
    for message in messages:
        same = next((fault for fault in faults if fault.keys().isdisjoint(message)), None)
        if same is None:
            faults.append(message)
        else:
            same.update(message)
    return faults


def _one_diagnostic(group: list[Diagnostic]) -> Diagnostic:
    first = min(
        group, key=lambda diagnostic: (-diagnostic.severity.weight, diagnostic.expanded_from, diagnostic.message)
    )
    chains = sorted({chain for diagnostic in group for chain in diagnostic.expanded_from})
    messages = {diagnostic.message for diagnostic in group}
    others = sorted(messages - {first.message})
    notes = first.notes
    if others:
        different = list(dict.fromkeys(filter(None, (difference(first.message, other) for other in others))))
        named = [name for name in different if name not in messages] or different
        most = _MAX_LIKEWISE if named and named[0] not in messages else 1
        rest = len(named) - most
        shown = "; ".join(named[:most]) + (f"; and {rest} more" if rest > 0 else "")
        notes = (Remark(f"likewise: {shown}"), *notes) if named else notes
    return first._replace(expanded_from=tuple(chains), notes=notes)


def _unused(outcomes: Iterable[Outcome], selection: Selection) -> Iterator[Diagnostic]:
    uses: dict[Location, SuppressionUse] = {}
    for outcome in outcomes:
        for use in outcome.suppressions:
            known = uses.get(use.at)
            uses[use.at] = use._replace(used=use.used or (known is not None and known.used))
    unused = [use for use in uses.values() if not use.used]
    if unused and selection.admits("UC099"):
        from urdfctl.rules.reading.suppression_unused import suppression_unused as fault

        for use in unused:
            message = fault.message(", ".join(use.codes) or "no code")
            severity = selection.severity(fault.code, fault.severity)
            yield Diagnostic(
                code=fault.code,
                name=fault.name,
                severity=severity,
                message=message,
                at=use.at,
                excerpt=use.excerpt,
                excerpt_column=use.excerpt_column,
            )


def worst(diagnostics: Iterable[Diagnostic]) -> Severity | None:
    """Return the worst severity; None if there are no diagnostics."""
    severities = (diagnostic.severity for diagnostic in diagnostics)
    return max(severities, key=lambda severity: severity.weight, default=None)


# -- files that several robots include: a part that suits one of them is not wrong for the others -------------------


def outcomes_of(results: Iterable[TargetResult]) -> list[Outcome]:
    """Return the outcomes of targets. A finding of such a rule is info if the part suits another robot of the run."""
    results = list(results)
    if len(results) > 1:
        from urdfctl.lint.findings.holders import with_robots

        results = with_robots(results, _OF_OTHER_ROBOTS)
    shown = Counter(place for result in results for place in _places(result.outcome))
    if not shown:
        return [result.outcome for result in results]
    readers = Counter(file for result in results if result.complete and result.links for file in set(result.files))

    def judged(finding: Diagnostic) -> Diagnostic:
        others = readers[finding.at.file] - shown[_place(finding)] if finding.code in _OF_OTHER_ROBOTS else 0
        return _of_another(finding, others) if others > 0 else finding

    return [
        result.outcome._replace(diagnostics=[judged(finding) for finding in result.outcome.diagnostics])
        for result in results
    ]


def _places(outcome: Outcome) -> set[tuple[str, str, int]]:
    return {_place(finding) for finding in outcome.diagnostics if finding.code in _OF_OTHER_ROBOTS}


def _place(finding: Diagnostic) -> tuple[str, str, int]:
    return finding.code, finding.at.file, finding.at.start


def _of_another(finding: Diagnostic, others: int) -> Diagnostic:
    """The finding without a hint: the name is right."""
    robots = "1 other robot has" if others == 1 else f"{others} other robots have"
    return finding._replace(
        severity=Severity.INFO,
        message=finding.message.partition("; did you mean")[0],
        fix=None,
        notes=(*finding.notes, Remark(f"this file is shared: {robots} it")),
    )
