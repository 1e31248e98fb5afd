"""All that is known of one rule, with its example and what linting it really says."""

from __future__ import annotations

import os
import tempfile
import textwrap

from urdfctl.catalog.distros import in_words
from urdfctl.lint import Selection, joined
from urdfctl.load import Loader, Target
from urdfctl.report.common import Report
from urdfctl.report.text import render
from urdfctl.rule import Rule
from urdfctl.rules.examples import companions, options_of, unmarked
from urdfctl.settings import Settings


def rule_explanation(rule: Rule) -> str:
    """What a rule finds, why it matters, by whose authority, and its examples."""
    parts = [
        f"{rule.code} {rule.name} ({rule.severity.value}; {in_words(rule.distros)})",
        rule.summary,
        *(textwrap.fill(paragraph, 100) for paragraph in rule.why.split("\n\n")),
        textwrap.fill(f"Authority: {rule.authority}", 100),
    ]
    if rule.bad:
        parts += ["Wrong:", *_files(rule.bad)]
        parts += [] if rule.of_smoke else ["What urdfctl says of it:", _output(rule)]
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
