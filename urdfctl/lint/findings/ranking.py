"""The order of a report: causes first."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.diagnostic import Diagnostic
from urdfctl.lint.findings.causes import EXPLAINS
from urdfctl.rules import FAMILIES

_TURN = {"reading": 0, "urdf": 1, "transmissions": 2, "ros2_control": 2, "simulation": 2}
"""When a runtime meets the faults of a family: what it meets first keeps it from all that comes after."""
_LAST = 3
_TURNS = {family.prefix: _TURN.get(family.name, _LAST) for family in FAMILIES}


def causes_first(findings: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Return findings by severity, the worst first; of one severity those that explain others, then what the runtime
    meets first, then by file and line."""
    return sorted(findings, key=_rank)


def _rank(finding: Diagnostic) -> tuple[int, bool, int, object]:
    explains = any(note.message.startswith(EXPLAINS) for note in finding.notes)
    turn = _TURNS.get(finding.code[:3], _LAST)
    return -finding.severity.weight, not explains, turn, finding.order
