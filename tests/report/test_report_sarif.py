"""The report as SARIF 2.1.0, read back by classes made from the official schema."""

from __future__ import annotations

import json
import os
from typing import Any

import pytest
from folder import Folder
from reported import bare, of_a_macro, report
from sarif_reader import read

from urdfctl.diagnostic import CallStep, Location, Remark, Repair, Severity, ShownEdit
from urdfctl.lint.results import Outcome, Report
from urdfctl.report.sarif import render

WHEEL = {"uri": "urdf/gro%C3%9Fe%20wheel.xacro", "uriBaseId": "%SRCROOT%"}
ROBOT = {"uri": "r.xacro", "uriBaseId": "%SRCROOT%"}
ELSEWHERE = {"uri": "file:///elsewhere/r.urdf"}


def run(given: Report) -> dict[str, Any]:
    """The run of a report as plain data, once it was read as SARIF."""
    text = render(given)
    read(text)
    plain: dict[str, Any] = json.loads(text)["runs"][0]
    return plain


def placed(artifact: dict[str, str], *region: int) -> dict[str, Any]:
    names = ("startLine", "startColumn", "endLine", "endColumn", "byteOffset", "byteLength")
    return {"physicalLocation": {"artifactLocation": artifact, "region": dict(zip(names, region, strict=False))}}


def test_a_finding_has_its_place_its_calls_its_notes_and_its_fix(folder: Folder) -> None:
    [result] = run(report(folder, of_a_macro(folder)))["results"]
    here, message = placed(WHEEL, 12, 7, 12, 28, 310, 23), "joint 'größe' has no <hardwareInterface>"
    mark = result.pop("partialFingerprints")
    assert list(mark) == ["urdfctl/v1"]
    assert result == {
        "ruleId": "UC201",
        "ruleIndex": 0,
        "level": "error",
        "message": {"text": f"{message}\nnote: for noetic\nfix: add it (safe)"},
        "locations": [here],
        "relatedLocations": [{"id": 1, **placed(WHEEL, 14, 1, 14, 3, 400, 2), "message": {"text": "so it is"}}],
        "codeFlows": [
            {
                "threadFlows": [
                    {
                        "locations": [
                            {
                                "location": {
                                    **placed({"uri": "file:///out.xacro"}, 1, 1),
                                    "message": {"text": "'r' is included"},
                                },
                                "nestingLevel": 0,
                            },
                            {
                                "location": {**placed(ROBOT, 6, 3), "message": {"text": "macro 'axle' is called"}},
                                "nestingLevel": 1,
                            },
                            {
                                "location": {**placed(WHEEL, 4, 3), "message": {"text": "macro 'wheel' is called"}},
                                "nestingLevel": 2,
                            },
                            {"location": {**here, "message": {"text": message}}, "nestingLevel": 3},
                        ]
                    }
                ]
            },
            {
                "threadFlows": [
                    {
                        "locations": [
                            {
                                "location": {**placed(ROBOT, 7, 3), "message": {"text": "macro 'wheel' is called"}},
                                "nestingLevel": 0,
                            },
                            {"location": {**here, "message": {"text": message}}, "nestingLevel": 1},
                        ]
                    }
                ]
            },
        ],
        "fixes": [
            {
                "description": {"text": "add it"},
                "artifactChanges": [
                    {
                        "artifactLocation": WHEEL,
                        "replacements": [
                            {
                                "deletedRegion": placed(WHEEL, 12, 26, 12, 28, 331, 2)["physicalLocation"]["region"],
                                "insertedContent": {"text": "><x/></joint>"},
                            }
                        ],
                    }
                ],
            }
        ],
    }


def test_a_run_tells_the_folder_the_files_and_how_columns_count(folder: Folder) -> None:
    given = run(report(folder, of_a_macro(folder), bare(Severity.INFO)))
    assert given["originalUriBaseIds"] == {"%SRCROOT%": {"uri": f"file://{folder.path}/"}}
    assert given["columnKind"] == "unicodeCodePoints"
    assert given["artifacts"] == [{"location": ELSEWHERE}, {"location": ROBOT}, {"location": WHEEL}]
    assert given["invocations"] == [{"executionSuccessful": True}]


def test_a_fault_of_ours_is_an_invocation_that_failed(folder: Folder) -> None:
    given = report(folder)
    crashed = given.targets[0]._replace(outcome=Outcome([], [], crashed=True))
    assert run(given._replace(targets=(crashed,)))["invocations"] == [{"executionSuccessful": False}]


def test_the_rules_of_the_findings_are_explained(folder: Folder) -> None:
    given = run(report(folder, of_a_macro(folder), bare(Severity.INFO)))
    rules = given["tool"]["driver"]["rules"]
    assert [(rule["id"], rule["name"]) for rule in rules] == [
        ("UC105", "several-root-links"),
        ("UC201", "transmission-joint-without-interface"),
    ]
    assert [result["ruleIndex"] for result in given["results"]] == [1, 0]
    explained = rules[1]
    assert explained["shortDescription"] == {"text": "Transmission joint without a hardware interface."}
    assert explained["defaultConfiguration"] == {"level": "error"}
    assert explained["help"]["text"].startswith(
        "Transmission joint without a hardware interface.\n\nros_control skips the joint, so no controller can"
    )
    assert "the interface belonged in &lt;actuator>; from" in explained["help"]["markdown"]
    assert '**Wrong**, `robot.urdf`:\n\n```\n<transmission name="elbow_trans">\n' in explained["help"]["markdown"]
    assert explained["properties"]["distros"][0] == "indigo"


def test_a_code_that_no_rule_has_is_told_all_the_same(folder: Folder) -> None:
    strange = bare(Severity.INFO)._replace(code="UC998", name="unheard-of")
    assert run(report(folder, strange))["tool"]["driver"]["rules"] == [{"id": "UC998", "name": "unheard-of"}]


def test_severities_are_in_sarifs_words(folder: Folder) -> None:
    results = run(report(folder, *(bare(severity) for severity in Severity)))["results"]
    assert [result["level"] for result in results] == ["error", "warning", "note"]


def test_a_run_without_findings_is_a_run(folder: Folder) -> None:
    assert (run(report(folder))["results"], run(Report((), ()))["results"]) == ([], [])


def test_a_fix_of_several_files_changes_each_of_them_and_one_without_edits_is_only_said(folder: Folder) -> None:
    one, other = (Location(f"/{name}.urdf", 1, 1, 1, 3, 0, 2) for name in "ab")
    edits = (ShownEdit(one, "x"), ShownEdit(other, "y"), ShownEdit(one._replace(line=2, end_line=2), "z"))
    several = bare(Severity.INFO)._replace(fix=Repair("both", safe=True, edits=edits))
    said = bare(Severity.INFO)._replace(fix=Repair("turn the screw", safe=False))
    first, second = run(report(folder, several, said))["results"]
    changes = first["fixes"][0]["artifactChanges"]
    assert [(c["artifactLocation"]["uri"], len(c["replacements"])) for c in changes] == [
        ("file:///a.urdf", 2),
        ("file:///b.urdf", 1),
    ]
    assert "fixes" not in second
    assert second["message"]["text"] == "it is so\nfix: turn the screw (by hand)"


@pytest.mark.parametrize(
    ("what", "told"),
    [
        ("macro m", "macro 'm' is called"),
        ("block", "a block is inserted"),
        ("include a.xacro", "'a.xacro' is included"),
        ("uncalled macro m", "macro m, which is not called in these files"),
    ],
)
def test_each_step_of_the_way_is_in_words(folder: Folder, what: str, told: str) -> None:
    one = bare(Severity.INFO)._replace(expanded_from=((CallStep("/r.xacro", 1, 2, what),),))
    [result] = run(report(folder, one))["results"]
    assert result["codeFlows"][0]["threadFlows"][0]["locations"][0]["location"]["message"] == {"text": told}


def test_what_a_file_writes_is_no_link(folder: Folder) -> None:
    message = "joint '[click](http://evil)' of axis [1 0 0] and [a] (b)"
    noted = bare(Severity.INFO, message)._replace(notes=(Remark("[x](1)", Location("/r", 1, 1, 1, 1, 0, 0)),))
    [result] = run(report(folder, noted))["results"]
    assert result["message"]["text"] == r"joint '\[click](http://evil)' of axis [1 0 0] and [a] (b)"
    assert result["relatedLocations"][0]["message"]["text"] == r"\[x](1)"


def test_paths_of_any_letters_are_uris(folder: Folder) -> None:
    names = {"a b#c?d%20.urdf": "a%20b%23c%3Fd%2520.urdf", "c:d.urdf": "c%3Ad.urdf", "腕.urdf": "%E8%85%95.urdf"}
    names[os.fsdecode(b"\xff.urdf")] = "%FF.urdf"
    for name, uri in names.items():
        [result] = run(report(folder, bare(Severity.INFO, file=str(folder.path / name))))["results"]
        assert result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == uri


def test_what_the_command_prints_is_sarif_whose_fix_mends_the_robot(folder: Folder) -> None:
    text = (
        '<robot name="größe"><link name="a"/><link name="b"/>\n'
        '<joint name="é" type="fixed"><parent link="a"/><child link="b"/></joint>\n'
        '<transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="é"/>\n'
        '<actuator name="m"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></actuator>'
        "</transmission></robot>\n"
    )
    folder.write({"r.urdf": text})
    ran = folder.run("lint", "r.urdf", "--format", "sarif", "--select", "UC201", "--distro", "noetic")
    read(ran.stdout)
    [result] = json.loads(ran.stdout)["runs"][0]["results"]
    region = result["locations"][0]["physicalLocation"]["region"]
    lines = text.splitlines()
    assert lines[region["startLine"] - 1][region["startColumn"] - 1 : region["endColumn"] - 1] == '<joint name="é"/>'
    [change] = result["fixes"][0]["artifactChanges"]
    [replacement] = change["replacements"]
    gone = replacement["deletedRegion"]
    line = lines[gone["startLine"] - 1]
    begin, end = gone["startColumn"] - 1, gone["endColumn"] - 1
    lines[gone["startLine"] - 1] = line[:begin] + replacement["insertedContent"]["text"] + line[end:]
    folder.write({"r.urdf": "\n".join(lines)})
    assert folder.run("lint", "r.urdf", "--select", "UC201", "--distro", "noetic").returncode == 0
    data = text.encode()
    inserted = replacement["insertedContent"]["text"].encode()
    mended = data[: gone["byteOffset"]] + inserted + data[gone["byteOffset"] + gone["byteLength"] :]
    assert mended.decode().splitlines() == lines
