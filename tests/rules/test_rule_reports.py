"""What lint says about the bad examples is what tests/rules/reports/ shows, which people have read."""

from __future__ import annotations

import pytest
from rule_reports import REPORTS, linted, report

from urdfctl.rules import Family


@pytest.mark.parametrize("family", linted(), ids=lambda family: family.name)
def test_lint_says_about_the_bad_examples_what_was_read(family: Family) -> None:
    shown = (REPORTS / f"{family.name}.txt").read_text(encoding="utf-8")
    assert report(family) == shown, "run python tests/helpers/rule_reports.py, and read what it changes"


def test_there_is_a_report_for_each_family() -> None:
    assert {path.stem for path in REPORTS.iterdir()} == {family.name for family in linted()}
