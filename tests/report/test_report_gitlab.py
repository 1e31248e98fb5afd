"""The report in GitLab's Code Quality form: what stands in it, and marks that stay although lines move."""

from __future__ import annotations

import json
from typing import Any

from folder import Folder
from reported import bare, of_a_macro, report

from urdfctl.diagnostic import Severity
from urdfctl.lint.results import Report
from urdfctl.report.gitlab import render


def issues(given: Report) -> list[dict[str, Any]]:
    """What GitLab would read; every entry must have what its documentation calls required."""
    read: list[dict[str, Any]] = json.loads(render(given))
    for issue in read:
        assert issue["severity"] in {"info", "minor", "major", "critical", "blocker"}
        assert {"description", "check_name", "fingerprint", "severity", "location"} == set(issue)
        assert not issue["location"]["path"].startswith("./")
    return read


def test_a_finding_is_an_issue(folder: Folder) -> None:
    [issue] = issues(report(folder, of_a_macro(folder)))
    mark = issue.pop("fingerprint")
    assert (len(mark), set(mark) <= set("0123456789abcdef")) == (32, True)
    assert issue == {
        "description": "UC201 joint 'größe' has no <hardwareInterface>",
        "check_name": "UC201 transmission-joint-without-interface",
        "severity": "major",
        "location": {"path": "urdf/große wheel.xacro", "lines": {"begin": 12, "end": 12}},
    }


def test_severities_are_in_gitlabs_words(folder: Folder) -> None:
    told = issues(report(folder, *(bare(severity) for severity in Severity)))
    assert [issue["severity"] for issue in told] == ["major", "minor", "info"]


def test_no_findings_are_an_empty_list(folder: Folder) -> None:
    assert render(report(folder)) == "[]\n"


def test_alike_findings_have_marks_of_their_own(folder: Folder) -> None:
    marks = [issue["fingerprint"] for issue in issues(report(folder, *[bare(Severity.INFO)] * 3))]
    assert len(set(marks)) == 3
    assert marks[:2] == [issue["fingerprint"] for issue in issues(report(folder, *[bare(Severity.INFO)] * 2))]


FAULTY = '<robot name="r">\n<link name="a"/>\n  <joint name="j" type="odd"/>\n</robot>\n'


def test_a_mark_stays_when_lines_move_and_wherever_the_checkout_stands(folder: Folder) -> None:
    moved = FAULTY.replace('<link name="a"/>', "<!-- more\n\n-->\n<link name='a'/>").replace("  <joint", "\t<joint")
    folder.write({"one/src/r.urdf": FAULTY, "two/src/r.urdf": moved, "three/src/r.urdf": FAULTY.replace("odd", "new")})
    words = ("lint", "src", "--format", "gitlab", "--select", "UC121")
    one, two, three = (
        json.loads(folder.run(*words, cwd=folder.path / name).stdout)[0] for name in ("one", "two", "three")
    )
    assert (one["location"]["lines"]["begin"], two["location"]["lines"]["begin"]) == (3, 6)
    assert one["fingerprint"] == two["fingerprint"] != three["fingerprint"]
    environ = {"CI_PROJECT_DIR": str(folder.path / "one")}
    inside = folder.run("lint", *words[2:], cwd=folder.path / "one/src", environ=environ)
    assert json.loads(inside.stdout) == [one]
