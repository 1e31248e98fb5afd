"""Each rule reports its bad examples at the marked places, and no rule reports a good example."""

from __future__ import annotations

from pathlib import Path

import pytest
import robots
from sampling import assert_each

from urdfctl.diagnostic import Diagnostic, ShownEdit
from urdfctl.fault import Example, Fault
from urdfctl.fix.edits import Splice, edited
from urdfctl.lint.examples import written
from urdfctl.rule import Rule
from urdfctl.rules import FAMILIES, all_faults, command_of, faults_found_by
from urdfctl.rules.examples import Mark, marked_lines, unmarked

FAULTS = all_faults()
LINTED = [fault for fault in faults_found_by("lint") if fault.code != "UC000"]
BAD = {f"{fault.code}-{number}": (fault, example) for fault in LINTED for number, example in enumerate(fault.bad, 1)}
GOOD = {
    f"{fault.code}-{number}": (fault, example)
    for fault in FAULTS
    if command_of(fault.code) != "doctor"  # whose examples are recordings
    for number, example in enumerate(fault.good, 1)
}


def findings(folder: Path, example: Example) -> list[Diagnostic]:
    """Return the findings in an example."""
    target, settings = written(example, str(folder))
    return robots.findings(target, settings=settings)


@pytest.mark.parametrize("name", BAD)
def test_a_bad_example_is_reported_at_the_marked_places_and_its_fixes_repair_it(name: str, tmp_path: Path) -> None:
    fault, example = BAD[name]
    files, marks = unmarked(example.files)
    reported = [finding for finding in findings(tmp_path, example) if finding.code == fault.code]
    places = [finding.at for finding in reported]
    assert marks, "the bad example marks no place with « and »"
    found = {Mark(Path(at.file).relative_to(tmp_path).as_posix(), at.start, at.end) for at in places}
    assert found == set(marks), f"marked:\n{marked_lines(files, marks)}\nreported:\n{marked_lines(files, found)}"
    edits = {Splice(edit.file, edit.start, edit.end, edit.text) for edit in fix_edits(reported)}
    if not edits:
        return
    repaired = {
        name: edited(text.encode(), [edit for edit in edits if edit.file == str(tmp_path / name)]).decode()
        for name, text in files.items()
    }
    remaining = [
        finding for finding in findings(tmp_path, example._replace(files=repaired)) if finding.code == fault.code
    ]
    assert fix_edits(remaining) == [], "the fix does not remove the finding"
    assert repaired != files


def fix_edits(reported: list[Diagnostic]) -> list[ShownEdit]:
    """Return the edits of all fixes of some findings."""
    return [edit for finding in reported if finding.fix for edit in finding.fix.edits]


@pytest.mark.parametrize("name", GOOD)
def test_a_good_example_is_silent_under_all_rules(name: str, tmp_path: Path) -> None:
    _, example = GOOD[name]
    reported = [f"{d.code} {d.message}" for d in findings(tmp_path, example)]
    assert reported == [], "reported:\n" + "\n".join(reported)


def test_a_fault_that_lint_finds_has_examples() -> None:
    def check(fault: Fault) -> None:
        assert fault.bad
        assert fault.good

    assert_each(check, {fault.code: fault for fault in LINTED})


def test_a_fault_that_lint_finds_is_a_rule_but_for_those_about_the_run_itself() -> None:
    others = [fault.name for fault in faults_found_by("lint") if not isinstance(fault, Rule)]
    assert others == ["rule-crashed", "suppression-unused"]


def test_a_fault_has_a_summary_a_reason_and_an_authority() -> None:
    def check(fault: Fault) -> None:
        assert fault.summary.endswith(".")
        assert fault.why
        assert fault.authority
        assert fault.distros

    assert_each(check, {fault.code: fault for fault in FAULTS})


def test_codes_and_names_are_unique_and_in_order() -> None:
    codes = [fault.code for fault in FAULTS]
    assert codes == sorted(set(codes))
    assert len({fault.name for fault in FAULTS}) == len(FAULTS)


def test_each_family_holds_the_faults_of_its_codes_and_no_others() -> None:
    for family in FAMILIES:
        assert {fault.code[: len(family.prefix)] for fault in family.load()} == {family.prefix}
