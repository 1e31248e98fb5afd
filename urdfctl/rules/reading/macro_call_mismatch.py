"""UC009."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC009",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py handle_macro_call(): 'Invalid parameter', 'Undefined parameters', 'Not enough blocks', 'Unused block'",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="wheel" params="side"><link name="${side}_wheel"/></xacro:macro>
                  <xacro:wheel side="left" radius="«0.1»"/>
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="wheel" params="side"><link name="${side}_wheel"/></xacro:macro>
                  <xacro:wheel side="left"/>
                </robot>
            """,
        },
    ],
)
def macro_call_mismatch(project: Project) -> Iterator[Finding]:
    """Macro call does not match the macro's parameters.

    xacro stops at a parameter that the macro does not have, at a parameter without a value, and at a missing or an
    extra block.
    """
    yield from findings_of(project, ProblemKind.MACRO_CALL)
