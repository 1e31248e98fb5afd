"""UC008."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC008",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py handle_macro_call(): 'unknown macro name'",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:wheel side="left"/>»
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
def unknown_macro(project: Project) -> Iterator[Finding]:
    """Macro is called before it is defined.

    xacro reads a file from top to bottom, and stops at a call of a macro that is not defined yet. The usual causes are
    a missing include and a misspelt name.
    """
    yield from findings_of(project, ProblemKind.UNKNOWN_MACRO)
