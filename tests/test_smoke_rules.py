"""The smoke test finds the fault in every bad example of its rules where it is marked, and none in the good ones."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from smoking import smoked, target_of, whole
from smoking_engines import needs_pybullet

from urdfctl.diagnostic import Diagnostic
from urdfctl.rule import Rule
from urdfctl.rules.examples import options_of, unmarked
from urdfctl.rules.smoke.family import RULES

STATIC = [rule for rule in RULES if rule.code < "UC920" or rule.code >= "UC950"]
MOVED = [rule for rule in RULES if "UC920" <= rule.code < "UC950"]


def found(folder: Path, rule: Rule, files: Any) -> list[Diagnostic]:
    """Return the findings in an example, with the rule's options; simulated if the rule needs it."""
    options, arguments = options_of(rule)
    target = target_of(folder, files, arguments)
    made = (smoked if rule in STATIC else whole)(target, workspace=str(folder), **options)
    return made.linted.outcome.diagnostics


def assert_found_where_it_is_marked(rule: Rule, folder: Path) -> None:
    _, marks = unmarked(rule.bad)
    (folder / "wheel.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99\n", encoding="utf-8")
    findings = [finding for finding in found(folder, rule, rule.bad) if finding.code == rule.code]
    assert {(Path(d.at.file).relative_to(folder).as_posix(), d.at.start, d.at.end) for d in findings} == set(marks)


@pytest.mark.parametrize("rule", [rule for rule in STATIC if rule.bad], ids=lambda rule: rule.code)
def test_the_bad_example_is_found_where_it_is_marked(rule: Rule, tmp_path: Path) -> None:
    assert_found_where_it_is_marked(rule, tmp_path)


@pytest.mark.parametrize("rule", STATIC, ids=lambda rule: rule.code)
def test_nothing_is_found_in_the_good_example(rule: Rule, tmp_path: Path) -> None:
    assert [f"{finding.code} {finding.message}" for finding in found(tmp_path, rule, rule.good)] == []


@needs_pybullet
@pytest.mark.parametrize("rule", [rule for rule in MOVED if rule.bad], ids=lambda rule: rule.code)
def test_the_bad_example_is_found_in_simulation_where_it_is_marked(rule: Rule, tmp_path: Path) -> None:
    assert_found_where_it_is_marked(rule, tmp_path)


@needs_pybullet
@pytest.mark.parametrize("rule", MOVED, ids=lambda rule: rule.code)
def test_nothing_is_found_in_simulation_the_good_example(rule: Rule, tmp_path: Path) -> None:
    assert [f"{finding.code} {finding.message}" for finding in found(tmp_path, rule, rule.good)] == []


def test_lint_finds_none_of_them() -> None:
    for rule in RULES:
        assert rule.of_smoke, rule.code
        assert list(rule.check(None)) == [], rule.code  # type: ignore[arg-type]
