"""What is shown about a rule: where its code is written, as in a comment or in urdfctl.toml, and at its findings."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from urdfctl.diagnostic import Diagnostic
from urdfctl.report.rule_explanation import runtime_of
from urdfctl.rule import Rule
from urdfctl.rules import all_rules
from urdfctl.rules.prose import as_markdown
from urdfctl.server.question import Question

_CODE = r"\bUC\d{3}\b"


def rules_at(question: Question, findings: Sequence[Diagnostic]) -> Iterator[str]:
    """Yield the rules at a place, each as Markdown. findings: those of the file."""
    line, column = question.source.line(question.line), question.column - 1
    written = [found[0] for found in re.finditer(_CODE, line) if found.start() <= column <= found.end()]
    found = [one.code for one in findings if one.at.start <= question.offset <= one.at.end]
    codes = dict.fromkeys([*written, *found])
    known = {rule.code: rule for rule in all_rules()} if codes else {}
    yield from (_described(known[code]) for code in codes if code in known)


def _described(rule: Rule) -> str:
    heading = f"**{rule.code}** {rule.name} ({rule.severity.value}): {rule.summary}"
    return as_markdown("\n\n".join(part for part in (heading, rule.why, runtime_of(rule)) if part))
