"""UC019."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC019",
    severity=Severity.INFO,
    runtime="works",
    authority="xacro/__init__.py eval_all(): an <xacro:arg> only stores its default",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:arg name="«prefix»" default="my_"/>
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:arg name="prefix" default="my_"/>
                  <link name="$(arg prefix)base"/>
                </robot>
            """,
        },
    ],
)
def argument_unused(project: Project) -> Iterator[Finding]:
    """Unused argument.

    Setting it changes nothing. The name may be misspelt where it is declared, or where it is used.
    """
    for finding in findings_of(project, ProblemKind.UNUSED_ARGUMENT):
        yield finding._replace(severity=Severity.WARNING) if finding.fix else finding
