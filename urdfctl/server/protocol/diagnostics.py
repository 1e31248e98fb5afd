"""Findings as an editor shows them."""

from __future__ import annotations

from lsprotocol import types

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.server.protocol.positions import Positions
from urdfctl.server.protocol.uris import uri_of

_SEVERITIES = {
    Severity.ERROR: types.DiagnosticSeverity.Error,
    Severity.WARNING: types.DiagnosticSeverity.Warning,
    Severity.INFO: types.DiagnosticSeverity.Information,
}


def shown_diagnostic(finding: Diagnostic, positions: Positions) -> types.Diagnostic:
    """Return a finding with its notes, and the calls that lead to it, as related places."""
    notes = [note for note in finding.notes if note.at is None]
    text = "\n".join([finding.message, *(f"note: {note.message}" for note in notes)])
    if finding.fix:
        text += f"\nfix: {finding.fix.title}"
    return types.Diagnostic(
        range=positions.range_of(finding.at),
        message=text,
        severity=_SEVERITIES[finding.severity],
        code=finding.code,
        code_description=types.CodeDescription(finding.url) if finding.url else None,
        source="urdfctl",
        related_information=_related(finding, positions),
        data={"code": finding.code, "start": finding.at.start, "end": finding.at.end},
    )


def _related(finding: Diagnostic, positions: Positions) -> list[types.DiagnosticRelatedInformation]:
    placed = [note for note in (*finding.notes, *finding.also) if note.at is not None]
    related = [
        types.DiagnosticRelatedInformation(positions.location_of(note.at), note.message) for note in placed if note.at
    ]
    for chain in finding.expanded_from:
        for step in chain:
            start = types.Position(step.line - 1, step.column - 1)
            place = types.Location(uri_of(step.file), types.Range(start, start))
            related.append(types.DiagnosticRelatedInformation(place, f"in {step.what}"))
    return related
