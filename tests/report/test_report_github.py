"""The report as workflow commands: what GitHub Actions would read in each line."""

from __future__ import annotations

import pytest
from folder import Folder
from reported import bare, of_a_macro, report

from urdfctl.diagnostic import Severity
from urdfctl.lint.results import Report
from urdfctl.report.github import render


def test_a_finding_is_one_command_with_all_that_is_said_of_it(folder: Folder) -> None:
    assert render(report(folder, of_a_macro(folder))) == (
        "::error file=urdf/große wheel.xacro,line=12,endLine=12,col=7,endColumn=28,"
        "title=UC201 transmission-joint-without-interface::joint 'größe' has no <hardwareInterface>"
        "%0Anote: in the call of macro 'wheel' at urdf/große wheel.xacro:4:3,"
        " in the call of macro 'axle' at r.xacro:6:3, included at /out.xacro:1:1"
        "%0Anote: in the call of macro 'wheel' at r.xacro:7:3"
        "%0Anote: so it is (line 14)"
        "%0Anote: for noetic"
        "%0Afix: add it (safe)\n"
    )


@pytest.mark.parametrize(
    ("severity", "command"), [(Severity.ERROR, "error"), (Severity.WARNING, "warning"), (Severity.INFO, "notice")]
)
def test_each_severity_has_its_command_and_columns_only_within_a_line(
    folder: Folder, severity: Severity, command: str
) -> None:
    told = render(report(folder, bare(severity)))
    assert told == f"::{command} file=/elsewhere/r.urdf,line=1,endLine=3,title=UC105 several-root-links::it is so\n"


def test_what_a_file_writes_is_neither_a_command_nor_a_property(folder: Folder) -> None:
    hostile = bare(Severity.ERROR, "100%0A::stop-commands::x\r\n::error::y\x1b[2J", "/a,line=9:b%\n::debug::.urdf")
    assert render(Report((), (hostile,))) == (
        "::error file=/a%2Cline=9%3Ab%25\\n%3A%3Adebug%3A%3A.urdf,line=1,endLine=3,title=UC105 several-root-links::"
        "100%250A::stop-commands::x\\r\\n::error::y\\x1b[2J\n"
    )


def test_nothing_found_is_said_in_the_log_of_the_step_and_is_no_command(folder: Folder) -> None:
    sound = report(folder)
    assert render(sound) == "no findings in r.xacro\n"
    assert render(sound._replace(known=40)) == "no findings in r.xacro; 40 hidden by the baseline\n"


def test_paths_count_from_the_root_of_the_checkout(folder: Folder) -> None:
    folder.write({"sub/r.urdf": '<robot name="r"><joint name="j" type="odd"/></robot>'})
    for workspace in (str(folder.path), f"{folder.path}/"):
        told = folder.run(
            *("lint", "r.urdf", "--format", "github"), cwd=folder.path / "sub", environ={"GITHUB_WORKSPACE": workspace}
        )
        assert {line.split(",")[0].split("file=")[1] for line in told.stdout.splitlines()} == {"sub/r.urdf"}
    for workspace in ("/nowhere", ""):
        told = folder.run(
            *("lint", "r.urdf", "--format", "github"), cwd=folder.path / "sub", environ={"GITHUB_WORKSPACE": workspace}
        )
        assert {line.split(",")[0].split("file=")[1] for line in told.stdout.splitlines()} == {"r.urdf"}
