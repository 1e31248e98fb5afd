"""UC003."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import fetched_apart
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import Problem, ProblemKind
from urdfctl.source.span import SourceSpan


@rule(
    "UC003",
    runtime="refuses",
    because="the package may be installed on the robot",
    severity=Severity.WARNING,
    authority="xacro/substitution_args.py _eval_find(): ament_index_python raises PackageNotFoundError",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:include filename="$(find arm_descripton)/wheel.xacro"/>»
                  <link name="base"/>
                </robot>
            """,
            "package.xml": '<package format="3"><name>arm_description</name></package>',
            "wheel.xacro": "<robot/>",
        },
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:include filename="$(find no_such_description)/urdf/wheel.xacro"/>»
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:include filename="$(find my_description)/wheel.xacro"/>
                </robot>
            """,
            "my_description/package.xml": """
                <package format="3"><name>my_description</name></package>
            """,
            "my_description/wheel.xacro": """
                <robot><link name="base"/></robot>
            """,
        },
    ],
)
def package_not_found(project: Project) -> Iterator[Finding]:
    """Package used by the description was not found.

    `$(find pkg)` stops xacro if the package is not built or its workspace is not sourced. A package that package.xml
    declares is not reported: the last line of the report names those that are not in the workspace. If a README, a script
    or a list of repositories says how to get it, this is only worth knowing. The name of the own package with one
    letter wrong is an error: there is no robot.
    """
    for problem, finding in zip(
        project.of_kind(ProblemKind.PACKAGE_NOT_FOUND), findings_of(project, ProblemKind.PACKAGE_NOT_FOUND), strict=True
    ):
        if not problem.correct:
            yield fetched_apart(project, problem.subject, finding)
            continue
        severity = Severity.WARNING if problem.guessed else Severity.ERROR
        yield finding._replace(severity=severity, fix=_written_right(problem))


def _written_right(problem: Problem) -> Fix:
    """The fix that writes the name of the package in the start tag where xacro stops."""
    source, title = problem.at.source, f"write '{problem.correct}'"
    tag = source.start_tag(problem.at.start)
    wrong = re.escape(problem.subject.encode())
    found = (
        [*re.finditer(rb"(?<=[\s(])" + wrong + rb"(?=[\s)])", source.data[problem.at.start : tag.end])] if tag else []
    )
    if len(found) != 1:
        return Fix(title)
    start = problem.at.start + found[0].start()
    edit = Edit(SourceSpan(source, start, start + len(problem.subject.encode())), problem.correct)
    return Fix(title, (edit,), safe=True)
