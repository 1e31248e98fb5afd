"""The report of the doctor: one answer first, then the rest, then what is fine."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from urdfctl.doctor.examination import Ailment
from urdfctl.doctor.run import DoctorReport
from urdfctl.output.printing import visible
from urdfctl.report.common import as_json, shown


def text_of(report: DoctorReport) -> str:
    """Return the report as text. The first line is the cause, or that all is well."""
    return "".join(f"{visible(line)}\n" for line in _lines(report))


def _lines(report: DoctorReport) -> Iterator[str]:
    if not report.ailments:
        yield f"ok: nothing differs from {shown(report.launch)}: {'; '.join(report.fine)}"
        return
    for ailment in report.ailments:
        yield f"{_place(ailment)}{ailment.severity.value} {ailment.code} {ailment.message}"
        yield from (f"  note: {note}" for note in ailment.notes)
    yield from (f"fine: {each}" for each in report.fine)
    yield f"compared with {shown(report.launch)}"


def _place(ailment: Ailment) -> str:
    return f"{shown(ailment.at)}: " if ailment.at else ""


def json_of(report: DoctorReport) -> str:
    """Return the report as JSON, version 1."""
    findings: list[dict[str, Any]] = [
        {
            "code": one.code,
            "name": one.name,
            "severity": one.severity.value,
            "message": one.message,
            "at": shown(one.at) or None,
            "notes": list(one.notes),
        }
        for one in report.ailments
    ]
    document = {"version": 1, "compared_with": shown(report.launch), "findings": findings, "fine": list(report.fine)}
    return as_json(document, 1) + "\n"
