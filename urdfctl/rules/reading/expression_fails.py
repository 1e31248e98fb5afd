"""UC010."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC010",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py eval_text(): re-raises whatever Python raised, 'when evaluating expression ...'",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="side" value="left"/>
                  <link name="«${side * 0.5}»"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="number" value="2"/>
                  <link name="link_${number * 2}"/>
                </robot>
            """,
        },
    ],
)
def expression_fails(project: Project) -> Iterator[Finding]:
    """Expression cannot be evaluated.

    The text in `${...}` is not a valid Python expression, or a value in it has the wrong type. xacro stops there.
    """
    yield from findings_of(project, ProblemKind.EXPRESSION)
