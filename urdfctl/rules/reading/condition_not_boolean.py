"""UC011."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC011",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py get_boolean_value(): '... which is not a boolean expression'",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:if value="yes">»<link name="camera"/></xacro:if>
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:if value="true"><link name="camera"/></xacro:if>
                </robot>
            """,
        },
    ],
)
def condition_not_boolean(project: Project) -> Iterator[Finding]:
    """Condition of `<xacro:if>` or `<xacro:unless>` is not a boolean.

    xacro accepts true, false, numbers, and the result of `${...}`. It stops at any other text.
    """
    yield from findings_of(project, ProblemKind.CONDITION)
