"""What is shown about a fault: where its code is written, as in a comment or in urdfctl.toml, and at its findings."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from urdfctl.diagnostic import Diagnostic
from urdfctl.fault import Fault
from urdfctl.report.fault_explanation import runtime_of
from urdfctl.rules import all_faults
from urdfctl.rules.prose import as_markdown
from urdfctl.server.analysis.question import Question

_CODE = r"\b[A-Z]{2,}\d{3,}\b"


def faults_at(question: Question, findings: Sequence[Diagnostic]) -> Iterator[str]:
    """Yield the faults at a place, each as Markdown. findings: those of the file."""
    line, column = question.source.line(question.line), question.column - 1
    written = [found[0] for found in re.finditer(_CODE, line) if found.start() <= column <= found.end()]
    found = [one.code for one in findings if one.at.start <= question.offset <= one.at.end]
    codes = dict.fromkeys([*written, *found])
    known = {fault.code: fault for fault in all_faults()} if codes else {}
    yield from (_described(known[code]) for code in codes if code in known)


def _described(fault: Fault) -> str:
    heading = f"**{fault.code}** {fault.name} ({fault.severity.value}): {fault.summary}"
    return as_markdown("\n\n".join(part for part in (heading, fault.why, runtime_of(fault)) if part))
