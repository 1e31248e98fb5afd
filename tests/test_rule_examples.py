"""Every rule's bad example is found where it is marked, and every good example is silent under all rules."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from urdfctl.diagnostic import Diagnostic
from urdfctl.fix.edits import Splice, edited
from urdfctl.lint import Selection, joined
from urdfctl.load import Loader, Target
from urdfctl.rule import Rule
from urdfctl.rules import FAMILIES, all_rules
from urdfctl.rules.examples import companions, options_of, unmarked
from urdfctl.settings import Settings

RULES = all_rules()
WITH_EXAMPLES = [rule for rule in RULES if rule.code != "UC000"]
OF_LINT = [rule for rule in WITH_EXAMPLES if not rule.of_smoke]


def findings(folder: Path, rule: Rule, files: Mapping[str, str]) -> list[Diagnostic]:
    """What linting an example's first file says, with the rule's options and its YAML and launch files."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    options, arguments = options_of(rule)
    settings = Settings(workspace=str(folder), **options)
    controllers, launch = companions(files)
    controllers = tuple(str(folder / name) for name in controllers)
    target = Target(
        str(folder / next(iter(files))), arguments, controllers=controllers, launch=launch and str(folder / launch)
    )
    linted = Loader(settings, Selection()).lint(target)
    return joined([linted.outcome], Selection())


@pytest.mark.parametrize("rule", OF_LINT, ids=lambda rule: rule.code)
def test_the_bad_example_is_found_where_it_is_marked(rule: Rule, tmp_path: Path) -> None:
    files, marks = unmarked(rule.bad)
    found = [d for d in findings(tmp_path, rule, files) if d.code == rule.code]
    assert marks, "the bad example marks no place with « and »"
    assert {(Path(d.at.file).relative_to(tmp_path).as_posix(), d.at.start, d.at.end) for d in found} == set(marks)


@pytest.mark.parametrize("rule", OF_LINT, ids=lambda rule: rule.code)
def test_the_repairs_of_the_bad_example_mend_it(rule: Rule, tmp_path: Path) -> None:
    files, _ = unmarked(rule.bad)
    found = [one for one in findings(tmp_path, rule, files) if one.code == rule.code and one.fix and one.fix.edits]
    edits = {Splice(edit.file, edit.start, edit.end, edit.text) for one in found if one.fix for edit in one.fix.edits}
    mended = {
        name: edited(text.encode(), [edit for edit in edits if edit.file == str(tmp_path / name)]).decode()
        for name, text in files.items()
    }
    left = [one for one in findings(tmp_path, rule, mended) if one.code == rule.code and one.fix and one.fix.edits]
    assert left == [], "the finding stays"
    assert bool(edits) == (mended != files)


@pytest.mark.parametrize("rule", WITH_EXAMPLES, ids=lambda rule: rule.code)
def test_the_good_example_is_silent_under_all_rules(rule: Rule, tmp_path: Path) -> None:
    assert rule.good
    files, _ = unmarked(rule.good)
    assert [f"{d.code} {d.message}" for d in findings(tmp_path, rule, files)] == []


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.code)
def test_a_rule_says_what_it_finds_why_and_by_whose_authority(rule: Rule) -> None:
    assert rule.summary.endswith(".")
    assert rule.why
    assert rule.authority
    assert rule.distros


def test_codes_and_names_are_unique_and_in_order() -> None:
    codes = [rule.code for rule in RULES]
    assert codes == sorted(set(codes))
    assert len({rule.name for rule in RULES}) == len(RULES)


def test_each_family_holds_the_rules_of_its_codes_and_no_others() -> None:
    for family in FAMILIES:
        assert {rule.code[: len(family.prefix)] for rule in family.load()} == {family.prefix}
