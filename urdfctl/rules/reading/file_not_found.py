"""UC002."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC002",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py parse(): raises 'No such file or directory'",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:include filename="wheel.xacro"/>»
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:include filename="wheel.xacro"/>
                </robot>
            """,
            "wheel.xacro": """
                <robot><link name="base"/></robot>
            """,
        },
    ],
)
def file_not_found(project: Project) -> Iterator[Finding]:
    """Included or loaded file does not exist.

    xacro stops at the first missing file, and no robot description is published.
    """
    yield from findings_of(project, ProblemKind.FILE_NOT_FOUND)
