"""UC014."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC014",
    severity=Severity.ERROR,
    authority="measured on 72 public repositories: the largest robot stays a hundred times below each limit",
    bad={
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
    good={
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
)
def over_budget(project: Project) -> Iterator[Finding]:
    """A description is too large to be expanded.

    Files over 16 MiB, elements nested more than 200 deep, 20 000 macro calls or a million elements: no robot
    needs so much, and an endless one must not hang a pipeline.
    """
    yield from findings_of(project, ProblemKind.BUDGET)
