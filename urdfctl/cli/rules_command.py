"""`urdfctl rules`."""

from __future__ import annotations

import json

from urdfctl.cli.writing import print_text
from urdfctl.errors import UserError
from urdfctl.lint.selection import Selection, validate_selection
from urdfctl.rule import Rule
from urdfctl.rules import all_rules


def run_rules(output_format: str, prefixes: tuple[str, ...]) -> int:
    """List the rules as a table or as JSON."""
    selection = validate_selection(Selection(prefixes))
    wanted = [rule for rule in all_rules() if selection.admits(rule.code)]
    if output_format == "json":
        print_text(json.dumps([plain_rule(rule) for rule in wanted], indent=1) + "\n")
    elif output_format == "text":
        print_text(
            "".join(f"{rule.code}  {rule.severity.value:<8} {rule.name:<44} {rule.summary}\n" for rule in wanted)
        )
    else:
        raise UserError(f"unknown format '{output_format}'; known are text, json")
    return 0


def plain_rule(rule: Rule) -> dict[str, object]:
    """Return a rule as plain data, for JSON."""
    return {
        "code": rule.code,
        "name": rule.name,
        "severity": rule.severity.value,
        "summary": rule.summary,
        "why": rule.why,
        "runtime": rule.runtime.value,
        "because": rule.because,
        "authority": rule.authority,
        "distros": list(rule.distros),
    }
