"""Merge the diagnostics of several targets: one for each fault, however many calls and robots show it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from urdfctl.diagnostic import Diagnostic, Location, Remark, Severity
from urdfctl.lint.causes import LINKS_OF_RUN, without_consequences
from urdfctl.lint.likeness import difference
from urdfctl.lint.results import Outcome, SuppressionUse
from urdfctl.lint.selection import Selection
from urdfctl.rules import rule_of

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
    others = sorted({diagnostic.message for diagnostic in group} - {first.message})
    notes = first.notes
    if others:
        different = list(dict.fromkeys(filter(None, (difference(first.message, other) for other in others))))
        named = [name for name in different if name not in others] or different
        most = _MAX_LIKEWISE if named and named[0] not in others else 1
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
        rule = rule_of("UC099")
        for use in unused:
            codes = ", ".join(use.codes) or "no code"
            message = f"unused suppression: there is no finding of {codes} on this line or the next"
            severity = selection.severity(rule.code, rule.severity)
            yield Diagnostic(rule.code, rule.name, severity, message, use.at, excerpt=use.excerpt)


def worst(diagnostics: Iterable[Diagnostic]) -> Severity | None:
    """Return the worst severity; None if there are no diagnostics."""
    severities = (diagnostic.severity for diagnostic in diagnostics)
    return max(severities, key=lambda severity: severity.weight, default=None)
