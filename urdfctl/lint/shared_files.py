"""Files that several robots include: a part that suits one of them is not wrong for the others."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from urdfctl.diagnostic import Diagnostic, Remark, Severity
from urdfctl.lint.results import Outcome, TargetResult

_OF_OTHER_ROBOTS = frozenset({"UC156"})
"""Rules about a part that refers to what the robot does not have, and that does no harm."""


def outcomes_of(results: Iterable[TargetResult]) -> list[Outcome]:
    """Return the outcomes of targets. A finding of such a rule is info if the part suits another robot of the run."""
    results = list(results)
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
