"""UC017."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC017",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="xacro/__init__.py grab_macro(): macros[name] = macro, over whatever was there",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="part"><link name="base"/></xacro:macro>
                  <xacro:macro name="«part»"><link name="other"/></xacro:macro>
                  <xacro:part/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:macro name="part"><link name="base"/></xacro:macro>
                  <xacro:part/>
                </robot>
            """,
        },
    ],
)
def macro_defined_twice(project: Project) -> Iterator[Finding]:
    """Macro is defined twice.

    xacro silently replaces the first definition. Calls before the second definition get one body, calls after it get
    the other.
    """
    yield from findings_of(project, ProblemKind.DUPLICATE_MACRO)
