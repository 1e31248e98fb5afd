"""UC004."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC004",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py parse(): open() raises IsADirectoryError or PermissionError",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:include filename="parts"/>»
                  <link name="base"/>
                </robot>
            """,
            "parts/README": """
                not a description
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:include filename="parts/wheel.xacro"/>
                </robot>
            """,
            "parts/wheel.xacro": """
                <robot><link name="base"/></robot>
            """,
        },
    ],
)
def file_unreadable(project: Project) -> Iterator[Finding]:
    """File cannot be read.

    The path is a folder or a device, or its permissions do not allow reading.
    """
    yield from findings_of(project, ProblemKind.FILE_UNREADABLE)
