"""The report as JUnit's XML, read back by an XML parser."""

from __future__ import annotations

from xml.etree import ElementTree as ET

from folder import Folder
from reported import bare, of_a_macro, report

from urdfctl.diagnostic import Severity
from urdfctl.lint.results import Report
from urdfctl.report.junit import render


def test_a_file_is_a_suite_and_a_finding_a_case(folder: Folder) -> None:
    given = report(folder, of_a_macro(folder), bare(Severity.WARNING), bare(Severity.INFO))
    assert render(given) == (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<testsuites name="urdfctl" tests="4" failures="1" errors="0" skipped="2">\n'
        '  <testsuite name="r.xacro" tests="1" failures="0" errors="0" skipped="0">\n'
        '    <testcase name="no findings" classname="r.xacro" file="r.xacro"/>\n'
        "  </testsuite>\n"
        '  <testsuite name="urdf/große wheel.xacro" tests="1" failures="1" errors="0" skipped="0">\n'
        '    <testcase name="UC201 transmission-joint-without-interface at 12:7" classname="urdf/große wheel.xacro"'
        ' file="urdf/große wheel.xacro" line="12">\n'
        '      <failure message="joint \'größe\' has no &lt;hardwareInterface&gt;" type="error">'
        "urdf/große wheel.xacro:12:7\n"
        "joint 'größe' has no &lt;hardwareInterface&gt;\n"
        "note: in the call of macro 'wheel' at urdf/große wheel.xacro:4:3, in the call of macro 'axle' at r.xacro:6:3,"
        " included at /out.xacro:1:1\n"
        "note: in the call of macro 'wheel' at r.xacro:7:3\n"
        "note: so it is (line 14)\n"
        "note: for noetic\n"
        "fix: add it (safe)</failure>\n"
        "    </testcase>\n"
        "  </testsuite>\n"
        '  <testsuite name="/elsewhere/r.urdf" tests="2" failures="0" errors="0" skipped="2">\n'
        '    <testcase name="UC105 several-root-links at 1:2" classname="/elsewhere/r.urdf"'
        ' file="/elsewhere/r.urdf" line="1">\n'
        '      <skipped message="warning: it is so"/>\n'
        "    </testcase>\n"
        '    <testcase name="UC105 several-root-links at 1:2" classname="/elsewhere/r.urdf"'
        ' file="/elsewhere/r.urdf" line="1">\n'
        '      <skipped message="info: it is so"/>\n'
        "    </testcase>\n"
        "  </testsuite>\n"
        "</testsuites>\n"
    )


def results(given: Report) -> list[str]:
    """What each test case came to, by the name of the element in it."""
    return [case[0].tag if len(case) else "passed" for case in ET.fromstring(render(given)).iter("testcase")]


def test_what_fails_the_run_is_a_failure(folder: Folder) -> None:
    findings = [bare(severity, file=str(folder.path / "r.xacro")) for severity in Severity]
    assert results(report(folder, *findings)) == ["failure", "skipped", "skipped"]
    assert results(report(folder, *findings, fail_on=Severity.INFO)) == ["failure"] * 3
    assert results(report(folder)) == ["passed"]


def test_a_fault_of_ours_is_an_error(folder: Folder) -> None:
    ours = bare(Severity.ERROR, "the rule crashed", str(folder.path / "r.xacro"))._replace(code="UC000")
    given = report(folder, ours)
    assert results(given) == ["error"]
    assert ET.fromstring(render(given)).attrib == {
        "name": "urdfctl",
        "tests": "1",
        "failures": "0",
        "errors": "1",
        "skipped": "0",
    }


def test_what_a_file_writes_ends_no_element(folder: Folder) -> None:
    hostile = bare(Severity.ERROR, ']]></failure>"&\x00\x0b\ufffe\udcff\n<x/>', '/a"<&\x07.urdf')
    [failure] = ET.fromstring(render(Report((), (hostile,)))).iter("failure")
    assert failure.get("message") == ']]></failure>"&\\x00\\x0b\ufffd\ufffd\\n<x/>'
    assert failure.text == '/a"<&\\x07.urdf:1:2\n]]></failure>"&\\x00\\x0b\ufffd\ufffd\\n<x/>'


def test_what_the_command_prints_agrees_with_its_exit_status(folder: Folder) -> None:
    folder.write({"r.urdf": '<robot name="r"><link name="a"/><joint name="j" type="odd"/></robot>'})
    ran = folder.run("lint", "r.urdf", "--format", "junit=report.xml", "--format", "text")
    root = ET.parse(folder.path / "report.xml").getroot()
    assert (ran.returncode, int(root.attrib["failures"]) > 0) == (1, True)
    assert f"{root.attrib['failures']} errors" in ran.stdout
