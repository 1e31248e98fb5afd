"""UC006."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC006",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py eval_text(): NameError 'name ... is not defined' when evaluating expression",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="radius" value="0.1"/>
                  <link name="«${raduis}»"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="prefix" value="my"/>
                  <link name="${prefix}_base"/>
                </robot>
            """,
        },
    ],
)
def undefined_name(project: Project) -> Iterator[Finding]:
    """Undefined name in an expression.

    xacro evaluates a property where it is used, and stops if it does not know a name there. The name is misspelt,
    defined later in the file, or defined inside another macro.
    """
    yield from findings_of(project, ProblemKind.UNDEFINED_NAME)
