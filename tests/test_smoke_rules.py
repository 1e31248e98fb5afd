"""The smoke test finds the fault in every bad example of its rules where it is marked, and none in the good ones."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from smoking import smoked, target_of

from urdfctl.diagnostic import Diagnostic
from urdfctl.rule import Rule
from urdfctl.rules.examples import options_of, unmarked
from urdfctl.rules.smoke import RULES


def found(folder: Path, rule: Rule, files: Any) -> list[Diagnostic]:
    """What the smoke test says of an example, with the rule's options."""
    options, arguments = options_of(rule)
    made = smoked(target_of(folder, files, arguments), workspace=str(folder), **options)
    return made.linted.outcome.diagnostics


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.code)
def test_the_bad_example_is_found_where_it_is_marked(rule: Rule, tmp_path: Path) -> None:
    _, marks = unmarked(rule.bad)
    told = [one for one in found(tmp_path, rule, rule.bad) if one.code == rule.code]
    assert {(Path(d.at.file).relative_to(tmp_path).as_posix(), d.at.start, d.at.end) for d in told} == set(marks)


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.code)
def test_nothing_is_found_in_the_good_example(rule: Rule, tmp_path: Path) -> None:
    assert [f"{one.code} {one.message}" for one in found(tmp_path, rule, rule.good)] == []


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.code)
def test_lint_tells_none_of_them(rule: Rule) -> None:
    assert rule.of_smoke
    assert list(rule.check(None)) == []  # type: ignore[arg-type]
