"""The JSON report keeps to its schema, counts columns in code points, and names files as reports show them."""

from __future__ import annotations

import json
import os
from copy import deepcopy
from importlib.resources import files
from typing import Any

import pytest
from folder import Folder
from jsonschema import Draft202012Validator, ValidationError

from urdfctl.diagnostic import CallStep, Diagnostic, Location, Remark, Repair, Severity, ShownEdit
from urdfctl.lint.results import Outcome, Report, TargetResult
from urdfctl.report import jsonl
from urdfctl.report.json_report import render

SCHEMA = json.loads(files("urdfctl.report").joinpath("lint.schema.json").read_text(encoding="utf-8"))
VALID = Draft202012Validator(SCHEMA)


def everything(folder: Folder) -> Report:
    """A report in which each thing that may be absent is there once, and absent once."""
    file = str(folder.path / "urdf/größe.xacro")
    where = Location(file, 12, 7, 12, 26, 310, 330)
    whole = Diagnostic(
        "UC201",
        "transmission-joint-without-interface",
        Severity.ERROR,
        "joint 'größe' has no <hardwareInterface>",
        where,
        (
            (
                CallStep(str(folder.path / "r.xacro"), 6, 3, "macro wheel"),
                CallStep("/out.xacro", 1, 1, "include r.xacro"),
            ),
        ),
        (Remark("so it is", where), Remark("for noetic")),
        Repair("add it", safe=True, edits=(ShownEdit(Location(file, 12, 7, 12, 7, 310, 310), "<x/>"),)),
        "an excerpt",
        "https://example.org/UC201",
    )
    bare = Diagnostic("UC105", "several-root-links", Severity.INFO, "bare", Location("/r.urdf", 1, 1, 1, 1, 0, 0))
    outcome = Outcome([whole, bare], [])
    yaml, launch = str(folder.path / "config/c.yaml"), str(folder.path / "launch/l.launch")
    known = TargetResult(file, 1, "noetic", "--distro", "gz", True, False, "r", 2, (file,), outcome, (yaml,), launch)
    unknown = TargetResult("/r.yaml", None, None, None, None, False, False, None, None, (), outcome)
    return Report((known, unknown), (whole, bare))


def test_the_schema_is_a_schema() -> None:
    Draft202012Validator.check_schema(SCHEMA)


def test_a_report_of_everything_keeps_to_the_schema_and_says_what_was_found(folder: Folder) -> None:
    given = json.loads(render(everything(folder)))
    VALID.validate(given)
    assert given["targets"] == [
        {
            "robot": "urdf/größe.xacro",
            "arguments": {},
            "controllers": ["config/c.yaml"],
            "launch": "launch/l.launch",
            "launch_arguments": {},
            "arguments_from": None,
            "beside": [],
            "includes": [],
            "namespace": None,
            "spawned": [],
            "moveit": False,
            "ros": 1,
            "distro": "noetic",
            "distro_from": "--distro",
            "simulator": "gz",
            "complete": True,
        },
        {
            "robot": None,
            "arguments": {},
            "controllers": [],
            "launch": None,
            "launch_arguments": {},
            "arguments_from": None,
            "beside": [],
            "includes": [],
            "namespace": None,
            "spawned": [],
            "moveit": False,
            "ros": None,
            "distro": None,
            "distro_from": None,
            "simulator": None,
            "complete": False,
        },
    ]
    assert given["findings"][0] == {
        "code": "UC201",
        "name": "transmission-joint-without-interface",
        "severity": "error",
        "message": "joint 'größe' has no <hardwareInterface>",
        "file": "urdf/größe.xacro",
        "line": 12,
        "column": 7,
        "end_line": 12,
        "end_column": 26,
        "expanded_from": [
            [
                {"file": "r.xacro", "line": 6, "column": 3, "what": "macro wheel"},
                {"file": "/out.xacro", "line": 1, "column": 1, "what": "include r.xacro"},
            ]
        ],
        "also": [],
        "notes": [
            {"message": "so it is", "file": "urdf/größe.xacro", "line": 12, "column": 7},
            {"message": "for noetic"},
        ],
        "fix": {
            "title": "add it",
            "safe": True,
            "edits": [{"file": "urdf/größe.xacro", "start": 310, "end": 310, "text": "<x/>"}],
        },
        "url": "https://example.org/UC201",
    }
    assert given["findings"][1]["fix"] is None
    assert given["summary"] == {"error": 1, "warning": 0, "info": 1, "known": 0}


def test_an_empty_report_keeps_to_the_schema() -> None:
    given = json.loads(render(Report((), ())))
    VALID.validate(given)
    assert given["findings"] == []


def objects(schema: Any, value: Any) -> list[Any]:
    """Every object in a value."""
    inside = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return ([value] if isinstance(value, dict) else []) + [found for item in inside for found in objects(schema, item)]


def test_the_schema_allows_nothing_that_it_does_not_name(folder: Folder) -> None:
    given = json.loads(render(everything(folder)))
    for number in range(len(objects(SCHEMA, given))):
        changed = deepcopy(given)
        objects(SCHEMA, changed)[number]["unheard-of"] = 1
        with pytest.raises(ValidationError):
            VALID.validate(changed)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("code", "X1"),
        ("severity", "fatal"),
        ("line", 0),
        ("column", "1"),
        ("fix", {}),
        ("message", ""),
        ("name", "A b"),
    ],
)
def test_the_schema_refuses_what_a_finding_never_is(folder: Folder, name: str, value: object) -> None:
    given = json.loads(render(everything(folder)))
    given["findings"][1][name] = value
    with pytest.raises(ValidationError):
        VALID.validate(given)


def test_what_the_command_prints_keeps_to_the_schema(folder: Folder) -> None:
    folder.write(
        {
            "urdf/r.xacro": '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
            '<xacro:macro name="m" params="n"><link name="${n}"/><joint name="é${n}" type="x"/></xacro:macro>\n'
            '\t<xacro:m n="a"/><xacro:m n="b"/>\n<xacro:include filename="none.xacro"/></robot>'
        }
    )
    ran = folder.run("lint", "urdf/r.xacro", "--format", "json")
    given = json.loads(ran.stdout)
    VALID.validate(given)
    assert ran.returncode == 1
    assert given["summary"]["error"] == len([f for f in given["findings"] if f["severity"] == "error"]) > 0
    assert {finding["file"] for finding in given["findings"]} == {"urdf/r.xacro"}


def test_columns_count_code_points_and_a_byte_order_mark_counts_nothing(folder: Folder) -> None:
    line = '<robot name="größe 🦾"><link name="a"/><joint name="j" type="sideways"/></robot>'
    folder.write({"r.urdf": "\ufeff" + line})
    findings = json.loads(folder.run("lint", "r.urdf", "--format", "json").stdout)["findings"]
    cut_out = {line[finding["column"] - 1 : finding["end_column"] - 1] for finding in findings}
    assert "sideways" in cut_out


def test_a_file_name_that_is_no_text_makes_no_broken_json(folder: Folder) -> None:
    name = os.fsdecode(b"r\xff.urdf")
    (folder.path / name).write_text('<robot name="r"/>')
    ran = folder.run("lint", name, "--format", "json", "--format", "json=report.json")
    given = json.loads((folder.path / "report.json").read_bytes())
    assert given == json.loads(ran.stdout)
    assert given["targets"][0]["robot"] == name


def test_json_lines_are_the_findings_one_a_line(folder: Folder) -> None:
    report = everything(folder)
    told = jsonl.render(report)
    assert told.splitlines()[1] == (
        '{"code": "UC105", "name": "several-root-links", "severity": "info", "message": "bare", "file": "/r.urdf",'
        ' "line": 1, "column": 1, "end_line": 1, "end_column": 1, "expanded_from": [], "also": [], "notes": [],'
        ' "fix": null, "url": null}'
    )
    assert [json.loads(line) for line in told.splitlines()] == json.loads(render(report))["findings"]
    assert jsonl.render(Report((), ())) == ""


def test_ends_of_lines_and_controls_are_escaped_and_other_letters_are_not(folder: Folder) -> None:
    message = "größe 腕\n\r\u2028\x85\x1b\x9b\u202e"
    one = everything(folder).findings[1]._replace(message=message)
    told = jsonl.render(Report((), (one,)))
    assert r'"message": "größe 腕\n\r\u2028\u0085\u001b\u009b\u202e"' in told
    assert json.loads(told)["message"] == message
