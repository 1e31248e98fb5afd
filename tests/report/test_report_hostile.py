"""Whatever robots, files and rules write, each report stays what it is, and tells each finding."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from urllib.parse import unquote
from xml.etree import ElementTree as ET

import pytest
from hostile.reports import OBEYED
from hypothesis import given, settings
from hypothesis import strategies as st
from sampling import examples
from sarif_reader import read

from urdfctl.diagnostic import CallStep, Diagnostic, Location, Remark, Repair, Severity, ShownEdit
from urdfctl.lint.results import Outcome, Report, TargetResult
from urdfctl.output.writing import encoded
from urdfctl.report import FORMATS, render

TEXTS = st.lists(st.one_of(st.sampled_from(OBEYED), st.text(st.characters(exclude_categories=())))).map("".join)
NAMES = st.binary(min_size=1).map(lambda name: "/" + os.fsdecode(name).replace("\x00", "?").lstrip("/"))
FEW = settings(max_examples=examples(10))
NUMBERS = st.integers(1, 300)


@st.composite
def places(draw: st.DrawFn) -> Location:
    line, column, start = draw(NUMBERS), draw(NUMBERS), draw(NUMBERS)
    lines, columns = draw(st.integers(0, 2)), draw(st.integers(0, 9))
    return Location(draw(NAMES), line, column, line + lines, column + columns, start, start + columns)


STEPS = st.builds(CallStep, NAMES, NUMBERS, NUMBERS, TEXTS.map("macro {}".format))
REPAIRS = st.builds(
    Repair, TEXTS, st.booleans(), st.lists(st.builds(ShownEdit, places(), TEXTS), max_size=3).map(tuple)
)
FINDINGS = st.builds(
    Diagnostic,
    st.sampled_from(["UC105", "UC201"]),
    st.just("a-fault"),
    st.sampled_from(Severity),
    TEXTS,
    places(),
    st.lists(st.lists(STEPS, min_size=1, max_size=3).map(tuple), max_size=2, unique=True).map(tuple),
    st.lists(st.builds(Remark, TEXTS, st.none() | places()), max_size=2).map(tuple),
    st.none() | REPAIRS,
    TEXTS.map(lambda text: "".join(text.splitlines())),
    st.none(),
    st.just(1),
    st.lists(st.builds(Remark, TEXTS, places()), max_size=2).map(tuple),
)


@st.composite
def reports(draw: st.DrawFn) -> Report:
    findings = tuple(draw(st.lists(FINDINGS, max_size=3)))
    robot = TargetResult(
        draw(NAMES), 1, None, None, None, True, False, "r", 2, (draw(NAMES),), Outcome([*findings], [])
    )
    return Report((robot,), findings)


def bytes_of(report: Report, name: str) -> bytes:
    """What is written of a report: UTF-8, in which bytes of file names may stand that are none; nothing to obey."""
    text = render(report, name)
    assert not re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028-\u202e\u2066-\u2069]", text)
    return encoded(text)


@FEW
@given(reports())
def test_json_and_json_lines_are_json(report: Report) -> None:
    whole = json.loads(bytes_of(report, "json"))
    lines = bytes_of(report, "jsonl").decode().splitlines()
    assert [json.loads(line) for line in lines] == whole["findings"]
    assert [finding["message"] for finding in whole["findings"]] == [one.message for one in report.findings]


@FEW
@given(reports())
def test_sarif_is_sarif(report: Report) -> None:
    results = read(bytes_of(report, "sarif").decode()).results
    assert [result.rule_id for result in results] == [one.code for one in report.findings]
    uris = [result.locations[0].physical_location.artifact_location.uri for result in results]
    for uri, one in zip(uris, report.findings, strict=True):
        assert os.path.abspath(unquote(uri.removeprefix("file://"), errors="surrogateescape")) == os.path.abspath(
            one.at.file
        )


@FEW
@given(reports())
def test_each_workflow_command_is_one_line_with_the_properties_that_we_give(report: Report) -> None:
    lines = bytes_of(report, "github").decode().splitlines()
    if not report.findings:
        [line] = lines
        assert line.startswith("no findings in ")
        return
    assert len(lines) == len(report.findings)
    for line in lines:
        command, properties, said = parsed(line)
        assert command in {"error", "warning", "notice"}
        assert [name for name, _ in properties if name not in {"col", "endColumn"}] == [
            "file",
            "line",
            "endLine",
            "title",
        ]
        assert "\r" not in said


def parsed(line: str) -> tuple[str, list[tuple[str, str]], str]:
    """A line as the runner of GitHub Actions reads it."""
    assert line.startswith("::")
    head, said = line[2:].split("::", 1)
    command, _, properties = head.partition(" ")
    pairs = [item.split("=", 1) for item in properties.split(",")]
    return command, [(name, unquote(value)) for name, value in pairs], unquote(said)


@FEW
@given(reports())
def test_gitlabs_is_a_list_of_issues_with_marks_of_their_own(report: Report) -> None:
    issues = json.loads(bytes_of(report, "gitlab").decode())
    assert len({issue["fingerprint"] for issue in issues}) == len(issues) == len(report.findings)


@FEW
@given(reports())
def test_junits_is_xml_with_a_case_for_each_finding(report: Report) -> None:
    root = ET.fromstring(bytes_of(report, "junit"))
    told = [case for case in root.iter("testcase") if len(case)]
    assert len(told) == len(report.findings)
    assert int(root.attrib["tests"]) == len(list(root.iter("testcase")))


@FEW
@given(reports())
def test_text_has_a_line_for_each_part_of_a_finding(report: Report) -> None:
    assert len(render(report, "concise").splitlines()) == len(report.findings)
    lines = render(report._replace(verbose=True), "text").splitlines()
    assert len(lines) >= 1 + sum(parts(report.findings))
    assert all(len(line) <= 120 or line.startswith("/") for line in lines)


def parts(findings: tuple[Diagnostic, ...]) -> Iterator[int]:
    """Yield the least number of lines of each finding; a note without a place may hold for all and be said once."""
    for one in findings:
        excerpt = 2 if one.excerpt.strip() else 0
        yield (
            1
            + excerpt
            + len(one.expanded_from)
            + sum(note.at is not None for note in one.notes)
            + bool(one.also)
            + (one.fix is not None)
        )


@pytest.mark.parametrize("name", FORMATS)
def test_the_same_findings_are_told_in_the_same_words_each_time(name: str) -> None:
    report = Report((), (Diagnostic("UC105", "x", Severity.INFO, "m", Location("/r", 1, 1, 1, 1, 0, 0)),))
    assert render(report, name) == render(report, name)
