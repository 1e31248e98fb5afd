"""`urdfctl rules` and `urdfctl explain`."""

from __future__ import annotations

import json
import os
import tempfile
import textwrap

from urdfctl.catalog.distros import in_words
from urdfctl.cli.writing import print_text
from urdfctl.errors import UserError
from urdfctl.lint import Selection, checked, joined
from urdfctl.load import Loader, Target
from urdfctl.report.common import Report
from urdfctl.report.text import render
from urdfctl.rule import Rule
from urdfctl.rules import all_rules
from urdfctl.rules.examples import companions, options_of, unmarked
from urdfctl.settings import Settings
from urdfctl.suggest import did_you_mean


def run_rules(output_format: str, prefixes: tuple[str, ...]) -> int:
    """List the rules as a table or as JSON."""
    selection = checked(Selection(prefixes))
    wanted = [rule for rule in all_rules() if selection.admits(rule.code)]
    if output_format == "json":
        print_text(json.dumps([_plain(rule) for rule in wanted], indent=1) + "\n")
    elif output_format == "text":
        print_text(
            "".join(f"{rule.code}  {rule.severity.value:<8} {rule.name:<44} {rule.summary}\n" for rule in wanted)
        )
    else:
        raise UserError(f"unknown format '{output_format}'; known are text, json")
    return 0


def _plain(rule: Rule) -> dict[str, object]:
    return {
        "code": rule.code,
        "name": rule.name,
        "severity": rule.severity.value,
        "summary": rule.summary,
        "why": rule.why,
        "authority": rule.authority,
        "distros": list(rule.distros),
    }


def run_explain(what: str) -> int:
    """Tell all that is known of one rule, with its example and the real output for it."""
    rule = next((rule for rule in all_rules() if what.upper() == rule.code or what.lower() == rule.name), None)
    if rule is None:
        known = [name for one in all_rules() for name in (one.code, one.name)]
        raise UserError(f"no rule '{what}'{did_you_mean(what, known)}; see urdfctl rules")
    print_text(explanation(rule))
    return 0


def explanation(rule: Rule) -> str:
    """What a rule finds, why it matters, by whose authority, and its examples."""
    parts = [
        f"{rule.code} {rule.name} ({rule.severity.value}; {in_words(rule.distros)})",
        rule.summary,
        *(textwrap.fill(paragraph, 100) for paragraph in rule.why.split("\n\n")),
        textwrap.fill(f"Authority: {rule.authority}", 100),
    ]
    if rule.bad:
        parts += ["Wrong:", *_files(rule.bad), "What urdfctl says of it:", _output(rule)]
        parts += ["Right:", *_files(rule.good)]
    parts.append(f"To silence it at one place: <!-- urdfctl: ignore[{rule.code}] the reason -->")
    return "\n\n".join(part for part in parts if part) + "\n"


def _files(files: dict[str, str]) -> list[str]:
    shown = []
    for name, text in files.items():
        plain = text.replace("«", "").replace("»", "")
        shown.append(textwrap.indent(f"{name}:\n{textwrap.indent(plain.rstrip(), '  ')}", "  "))
    return shown


def _output(rule: Rule) -> str:
    """What linting the wrong example really says."""
    files, _ = unmarked(rule.bad)
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = os.path.join(folder, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        options, arguments = options_of(rule)
        try:
            os.chdir(folder)
            selection = Selection()
            settings = Settings(workspace=os.getcwd(), **options)
            controllers, launch = companions(files)
            target = Target(next(iter(files)), arguments, controllers=controllers, launch=launch)
            linted = Loader(settings, selection).lint(target)
            found = [one for one in joined([linted.outcome], selection) if one.code == rule.code]
            report = Report((), tuple(found))
            return textwrap.indent("\n".join(render(report).splitlines()[:-1]), "  ")
        finally:
            os.chdir(before)
