"""What lint says about each bad example of a rule, as text: python tests/helpers/rule_reports.py writes them anew.

Messages are for people. This shows them as they read, and a change of a rule shows what it changes for its users.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from pathlib import Path

import robots

from urdfctl.diagnostic import Diagnostic, Location
from urdfctl.fault import Example, Fault
from urdfctl.lint.examples import written
from urdfctl.rules import FAMILIES, Family

REPORTS = Path(__file__).parents[1] / "rules" / "reports"


def linted() -> list[Family]:
    """Return the families of the faults that lint finds."""
    return [family for family in FAMILIES if family.found_by == "lint"]


def report(family: Family) -> str:
    """Return what lint says about the bad examples of a family."""
    parts = []
    for fault in family.load():
        for number, example in enumerate(fault.bad, 1):
            found = "".join(f"  {line}\n" for line in lines(fault, example))
            parts.append(f"{fault.code}-{number} {fault.name}\n{found}")
    return "\n".join(parts)


def lines(fault: Fault, example: Example) -> Iterator[str]:
    """Yield the lines of the findings of a fault in an example: places, messages, notes and fixes."""
    with tempfile.TemporaryDirectory() as made:
        folder = os.path.realpath(made)
        target, settings = written(example, folder)
        for finding in robots.findings(target, settings=settings):
            said = lines_of(finding) if finding.code == fault.code else ()
            yield from (line.replace(f"{folder}{os.sep}", "").replace(folder, "FOLDER") for line in said)


def lines_of(finding: Diagnostic) -> Iterator[str]:
    """Yield the lines of a finding."""
    yield f"{_place(finding.at)}: {finding.severity.value}: {finding.message}"
    for note in (*finding.also, *finding.notes):
        yield f"  note: {note.message}" + (f" ({_place(note.at)})" if note.at else "")
    if finding.fix:
        yield f"  fix{' (safe)' if finding.fix.safe else ''}: {finding.fix.title}"
        for edit in finding.fix.edits:
            at = edit.at
            yield f"    {_place(at)} to {at.end_line}:{at.end_column}: {edit.text!r}"


def _place(at: Location) -> str:
    return f"{at.file}:{at.line}:{at.column}"


if __name__ == "__main__":
    REPORTS.mkdir(exist_ok=True)
    for one in linted():
        (REPORTS / f"{one.name}.txt").write_text(report(one), encoding="utf-8")
