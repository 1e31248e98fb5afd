"""Writes README.md of this folder, the table of the rules: `python -m urdfctl.rules.readme > urdfctl/rules/README.md`."""

from __future__ import annotations

import sys

from urdfctl.catalog.distros import in_words
from urdfctl.rule import Rule
from urdfctl.rules import FAMILIES

_HEAD = """\
# The rules

One file a rule, named after the fault; `urdfctl explain CODE` tells the whole of it, with examples. This page is
made by `python -m urdfctl.rules.readme > urdfctl/rules/README.md`.
"""
_TABLE = """\
| code | name | severity | distros | what is wrong |
|---|---|---|---|---|
"""


def readme() -> str:
    """The page: a table for each family."""
    return "\n".join([_HEAD, *(_section(family.load()) for family in FAMILIES)])


def _section(rules: tuple[Rule, ...]) -> str:
    """A family under what its list says of it."""
    package = rules[0].check.__module__.rpartition(".")[0]
    listed = sys.modules.get(f"{package}.family", sys.modules[package])
    title = (listed.__doc__ or rules[0].code[:3]).split("\n\n")[0].strip().removesuffix(".")
    return f"## {title}\n\n{_TABLE}{''.join(map(_row, rules))}"


def _row(rule: Rule) -> str:
    path = rule.check.__module__.removeprefix("urdfctl.rules.").replace(".", "/")
    summary = rule.summary.replace("|", "\\|")
    cells = f"[{rule.code}]({path}.py)", rule.name, rule.severity.value, in_words(rule.distros), _plain(summary)
    return f"| {' | '.join(cells)} |\n"


def _plain(text: str) -> str:
    """A text whose angle brackets, outside of code, Markdown does not take for HTML."""
    parts = text.split("`")
    return "`".join(part if index % 2 else part.replace("<", "&lt;") for index, part in enumerate(parts))


if __name__ == "__main__":
    sys.stdout.write(readme())
