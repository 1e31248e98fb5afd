"""UC015."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC015",
    severity=Severity.ERROR,
    authority="xacro/__init__.py safe_eval(): looks at the top-level names only",
    bad={
        "robot.xacro": """
            <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <link name="«${().__class__}»"/>
            </robot>
        """,
    },
    good={
        "robot.xacro": """
            <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <link name="${'base'.upper()}"/>
            </robot>
        """,
    },
)
def forbidden_expression(project: Project) -> Iterator[Finding]:
    """An expression reaches for more than a description needs.

    xacro evaluates `${...}` and `$(eval ...)` as Python, and its own checks can be got round. urdfctl
    evaluates arithmetic, texts, lists and the functions that xacro offers, and nothing that leads to the
    interpreter. `--trust` lifts this.
    """
    yield from findings_of(project, ProblemKind.FORBIDDEN_EXPRESSION)
