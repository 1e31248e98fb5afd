"""UC003."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


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
    declares is not reported: the last line of the report names those that are not in the workspace.
    """
    yield from findings_of(project, ProblemKind.PACKAGE_NOT_FOUND)
