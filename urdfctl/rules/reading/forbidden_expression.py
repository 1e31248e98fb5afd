"""UC015."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC015",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py safe_eval(): looks at the top-level names only",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <link name="«${().__class__}»"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <link name="${'base'.upper()}"/>
                </robot>
            """,
        },
    ],
)
def forbidden_expression(project: Project) -> Iterator[Finding]:
    """Expression is not allowed.

    xacro evaluates `${...}` and `$(eval ...)` as Python, and its own checks can be bypassed. urdfctl evaluates
    arithmetic, strings, lists and the functions that xacro offers. It rejects everything that gives access to the
    Python interpreter. `--trust` turns this check off.
    """
    yield from findings_of(project, ProblemKind.FORBIDDEN_EXPRESSION)
