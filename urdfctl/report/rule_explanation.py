"""The explanation of a rule, with its examples and the real output of lint."""

from __future__ import annotations

import os
import tempfile
import textwrap

from urdfctl.catalog.distros import in_words
from urdfctl.config.settings import Settings
from urdfctl.lint.merging import merge
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.report.common import Report, relative
from urdfctl.report.text import render
from urdfctl.rule import Rule, Runtime
from urdfctl.rules.examples import companions, options_of, unmarked


def rule_explanation(rule: Rule) -> str:
    """Return the rule's summary, reason, authority and examples as text."""
    parts = [
        f"{rule.code} {rule.name} ({rule.severity.value}; {in_words(rule.distros)})",
        rule.summary,
        *(textwrap.fill(paragraph, 100) for paragraph in rule.why.split("\n\n")),
        runtime_of(rule),
        textwrap.fill(f"Authority: {rule.authority}", 100),
    ]
    if rule.bad:
        parts += ["Wrong:", *_files(rule.bad)]
        parts += [] if rule.of_smoke else ["Output of urdfctl lint:", _output(rule)]
        parts += ["Right:", *_files(rule.good)]
    parts.append(f"To ignore it in one place: <!-- urdfctl: ignore[{rule.code}] the reason -->")
    return "\n\n".join(part for part in parts if part) + "\n"


def runtime_of(rule: Rule) -> str:
    """Return what ROS or Gazebo does with the fault, and why the severity is not the usual one for that.

    Empty for a rule of the smoke test.
    """
    if rule.of_smoke:
        return ""
    does = {
        Runtime.REFUSES: "rejects the part, or does not start or move it",
        Runtime.CRASHES: "ends with an error",
        Runtime.DROPS: "goes on without the part",
        Runtime.IGNORES: "ignores what is written",
        Runtime.MISBEHAVES: "does something else than what was meant",
        Runtime.WARNS: "warns and goes on",
        Runtime.WORKS: "works",
    }[rule.runtime]
    because = f"; {rule.severity.value}, because {rule.because}" if rule.because else ""
    return textwrap.fill(f"Runtime: {does}{because}.", 100)


def _files(files: dict[str, str]) -> list[str]:
    shown = []
    for name, text in files.items():
        plain = text.replace("«", "").replace("»", "")
        shown.append(textwrap.indent(f"{name}:\n{textwrap.indent(plain.rstrip(), '  ')}", "  "))
    return shown


def _output(rule: Rule) -> str:
    """Return the real output of lint for the bad example."""
    files, _ = unmarked(rule.bad)
    with tempfile.TemporaryDirectory() as made:
        folder = os.path.realpath(made)
        for name, text in files.items():
            path = os.path.join(folder, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        options, arguments = options_of(rule)
        selection = Selection()
        controllers, launch = companions(files)
        target = Target(
            os.path.join(folder, next(iter(files))),
            arguments,
            controllers=tuple(os.path.join(folder, name) for name in controllers),
            launch=os.path.join(folder, launch) if launch else None,
        )
        linted = lint_target(Loader(Settings(workspace=folder, **options)), target, selection).result
        findings = (finding for finding in merge([linted.outcome], selection) if finding.code == rule.code)
        report = Report((), tuple(relative(finding, folder) for finding in findings))
        return textwrap.indent("\n".join(render(report).splitlines()[:-1]), "  ")
