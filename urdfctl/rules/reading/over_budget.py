"""UC014."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC014",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="measured on 72 public repositories: the largest robot is a hundred times below each limit",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="again">
                    «<xacro:again/>»
                  </xacro:macro>
                  <xacro:again/>
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="chain" params="n">
                    <link name="link_${n}"/>
                    <xacro:if value="${n > 0}"><xacro:chain n="${n - 1}"/></xacro:if>
                  </xacro:macro>
                  <xacro:chain n="0"/>
                </robot>
            """,
        },
    ],
)
def over_budget(project: Project) -> Iterator[Finding]:
    """Description is too large to be expanded.

    urdfctl stops there. The limits are 16 MiB a file, 200 levels of nested elements, 20 000 macro calls, a million
    elements, and 65 536 characters in a value of a launch file. No real robot comes close, and an endless description
    must not block a pipeline.
    """
    yield from findings_of(project, ProblemKind.BUDGET)
