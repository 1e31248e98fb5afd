"""Each rule reports its bad example at the marked places, and no rule reports a good example."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
import robots
from sampling import assert_each

from urdfctl.diagnostic import Diagnostic, Replacement
from urdfctl.fix.edits import Splice, edited
from urdfctl.load.target import Target
from urdfctl.rule import Rule
from urdfctl.rules import FAMILIES, all_rules
from urdfctl.rules.examples import companions, options_of, unmarked

RULES = all_rules()
WITH_EXAMPLES = [rule for rule in RULES if rule.code != "UC000"]
OF_LINT = [rule for rule in WITH_EXAMPLES if not rule.of_smoke]


def findings(folder: Path, rule: Rule, files: Mapping[str, str]) -> list[Diagnostic]:
    """Return the findings in an example's first file, with the rule's options, YAML and launch files."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    options, arguments = options_of(rule)
    controllers, launch = companions(files)
    controllers = tuple(str(folder / name) for name in controllers)
    target = Target(
        str(folder / next(iter(files))), arguments, controllers=controllers, launch=launch and str(folder / launch)
    )
    return robots.findings(target, workspace=str(folder), **options)


@pytest.mark.parametrize("rule", OF_LINT, ids=lambda rule: rule.code)
def test_the_bad_example_is_reported_at_the_marked_places_and_its_fixes_repair_it(rule: Rule, tmp_path: Path) -> None:
    files, marks = unmarked(rule.bad)
    reported = [finding for finding in findings(tmp_path, rule, files) if finding.code == rule.code]
    places = [finding.at for finding in reported]
    assert marks, "the bad example marks no place with « and »"
    assert {(Path(at.file).relative_to(tmp_path).as_posix(), at.start, at.end) for at in places} == set(marks)
    edits = {Splice(edit.file, edit.start, edit.end, edit.text) for edit in fix_edits(reported)}
    if not edits:
        return
    repaired = {
        name: edited(text.encode(), [edit for edit in edits if edit.file == str(tmp_path / name)]).decode()
        for name, text in files.items()
    }
    remaining = [finding for finding in findings(tmp_path, rule, repaired) if finding.code == rule.code]
    assert fix_edits(remaining) == [], "the fix does not remove the finding"
    assert repaired != files


def fix_edits(reported: list[Diagnostic]) -> list[Replacement]:
    """Return the edits of all fixes of some findings."""
    return [edit for finding in reported if finding.fix for edit in finding.fix.edits]


@pytest.mark.parametrize("rule", WITH_EXAMPLES, ids=lambda rule: rule.code)
def test_the_good_example_is_silent_under_all_rules(rule: Rule, tmp_path: Path) -> None:
    assert rule.good
    files, _ = unmarked(rule.good)
    assert [f"{d.code} {d.message}" for d in findings(tmp_path, rule, files)] == []


def test_a_rule_has_a_summary_a_reason_and_an_authority() -> None:
    def check(rule: Rule) -> None:
        assert rule.summary.endswith(".")
        assert rule.why
        assert rule.authority
        assert rule.distros

    assert_each(check, {rule.code: rule for rule in RULES})


def test_codes_and_names_are_unique_and_in_order() -> None:
    codes = [rule.code for rule in RULES]
    assert codes == sorted(set(codes))
    assert len({rule.name for rule in RULES}) == len(RULES)


def test_each_family_holds_the_rules_of_its_codes_and_no_others() -> None:
    for family in FAMILIES:
        assert {rule.code[: len(family.prefix)] for rule in family.load()} == {family.prefix}
