"""What the reports share."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace

from urdfctl.diagnostic import Diagnostic, Location, Severity
from urdfctl.load import Linted


@dataclass(frozen=True, slots=True)
class Report:
    """What a run found: the robots it looked at, and the findings in their stable order."""

    targets: tuple[Linted, ...]
    findings: tuple[Diagnostic, ...]

    def count(self, severity: Severity) -> int:
        """How many findings have a severity."""
        return sum(finding.severity is severity for finding in self.findings)


def shown(path: str) -> str:
    """A path as reports show it: relative to the current folder where it lies in it, with forward slashes."""
    current = os.getcwd().rstrip(os.sep) + os.sep
    return (path[len(current) :] if path.startswith(current) else path).replace(os.sep, "/")


def relative(diagnostic: Diagnostic) -> Diagnostic:
    """A diagnostic whose paths are as reports show them."""
    fix = diagnostic.fix
    return replace(
        diagnostic,
        at=_located(diagnostic.at),
        expanded_from=tuple(
            tuple(replace(step, file=shown(step.file)) for step in chain) for chain in diagnostic.expanded_from
        ),
        notes=tuple(replace(note, at=_located(note.at) if note.at else None) for note in diagnostic.notes),
        fix=replace(fix, edits=tuple(replace(edit, file=shown(edit.file)) for edit in fix.edits)) if fix else None,
    )


def _located(at: Location) -> Location:
    return replace(at, file=shown(at.file))
