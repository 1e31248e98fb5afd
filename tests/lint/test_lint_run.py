"""The stages of a run of lint give a caller the findings of the command, once each; an editor gets the same."""

from __future__ import annotations

import json
import os

import pytest
from folder import Folder

from urdfctl.config.file import Config, config_for
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.errors import UserError
from urdfctl.lint.judging import judge
from urdfctl.lint.results import TargetResult
from urdfctl.lint.run import LintRequest, find, in_workers, lint, merge, plan, report
from urdfctl.server.analysis.workspace import EditorSettings, Workspace

SHARED = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <gazebo reference="camera"><mu1>0.9</mu1></gazebo>
</robot>
"""
ROBOT = """\
<robot name="{name}" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="shared.xacro"/>
  <link name="base"/><link name="{link}"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="{link}"/></joint>
  <transmission name="t"><joint name="gone"/></transmission>
</robot>
"""
FILES = {
    "package.xml": "<package><name>p</name></package>",
    "shared.xacro": SHARED,
    "with.xacro": ROBOT.format(name="with", link="camera"),
    "without.xacro": ROBOT.format(name="without", link="lidar"),
}


def request(folder: Folder, config: Config | None = None) -> LintRequest:
    """A request for all of a folder."""
    return LintRequest((str(folder.path),), config or Config(), Settings())


def told(findings: list[Diagnostic]) -> list[tuple[str, str, str, int]]:
    """What a report says of findings first."""
    return [
        (finding.code, finding.severity.value, os.path.basename(finding.at.file), finding.at.line)
        for finding in findings
    ]


def by_command(folder: Folder) -> list[tuple[str, str, str, int]]:
    """The findings of the command."""
    found = json.loads(folder.run("lint", ".", "--format", "json", "--jobs", "1").stdout)["findings"]
    return [(one["code"], one["severity"], os.path.basename(one["file"]), one["line"]) for one in found]


def test_a_caller_gets_the_findings_of_the_command(folder: Folder) -> None:
    folder.write(FILES)
    asked = request(folder)
    made = report(lint(asked), asked)
    assert ("UC156", "info", "shared.xacro", 2) in told(list(made.findings))
    assert told(list(made.findings)) == by_command(folder)
    assert [target.robot for target in made.targets] == ["with", "without"]


def test_a_launch_file_that_cannot_be_read_is_reported_beside_the_robot_that_it_should_start(folder: Folder) -> None:
    folder.write(
        FILES | {"launch/arm.launch": '<launch>\n<<<<<<< ours\n<param name="robot_description"/>\n>>>>>>> theirs\n'}
    )
    assert ("UC034", "error", "arm.launch", 2) in by_command(folder)


def test_the_stages_one_by_one_are_the_run(folder: Folder) -> None:
    folder.write(FILES)
    asked = request(folder)
    run = judge(plan(find(asked), asked), in_workers(asked))
    assert told(merge(run.results, asked)) == told(merge(lint(asked).results, asked))


def test_an_editor_says_of_a_shared_file_what_the_command_says(folder: Folder) -> None:
    folder.write(FILES)
    found = Workspace(str(folder.path), EditorSettings()).check().findings
    shown = [one for findings in found.values() for one in findings if one.code == "UC156"]
    assert told(shown) == [one for one in by_command(folder) if one[0] == "UC156"]


def test_what_a_file_ignores_is_not_merged(folder: Folder) -> None:
    folder.write({**FILES, "urdfctl.toml": '[per-file-ignores]\n"shared.xacro" = ["UC156"]\n'})
    asked = request(folder, config_for((str(folder.path),)))
    assert "UC156" not in {finding.code for finding in merge(lint(asked).results, asked)}


def test_what_a_baseline_knows_is_counted_and_not_reported(folder: Folder) -> None:
    folder.write(FILES)
    asked = request(folder)
    made = report(lint(asked), asked, unknown=lambda findings, _: findings[1:])
    assert made.known == 1
    assert len(made.findings) < len(report(lint(asked), asked).findings)


def test_the_results_can_be_watched_as_they_come(folder: Folder) -> None:
    folder.write({name: FILES[name] for name in ("package.xml", "shared.xacro", "with.xacro")})
    seen: list[tuple[str | None, int]] = []

    def noted(result: TargetResult, number: int) -> TargetResult:
        seen.append((result.robot, number))
        return result

    lint(request(folder), watch=lambda results, number: (noted(result, number) for result in results))
    assert ("with", 1) in seen


def test_nothing_to_lint_is_an_error_and_a_report_without_findings_is_none(folder: Folder) -> None:
    with pytest.raises(UserError, match="nothing to lint in "):
        lint(request(folder))
    folder.write({"one.urdf": '<robot name="r"><link name="a"/></robot>'})
    asked = request(folder)._replace(paths=("one.urdf",))
    assert report(lint(asked), asked, fail_on=Severity.INFO).findings == ()
