"""UC020."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC020",
    severity=Severity.WARNING,
    authority="xacro/__init__.py LEXER: an expression is '$' followed by '{'",
    bad={
        "robot.xacro": """
            <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <xacro:property name="side" value="left"/>
              <link name="«{side}_wheel»"/>
            </robot>
        """,
    },
    good={
        "robot.xacro": """
            <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <xacro:property name="side" value="left"/>
              <link name="${side}_wheel"/>
            </robot>
        """,
    },
)
def braces_without_dollar(project: Project) -> Iterator[Finding]:
    """A property's name stands in braces without the dollar.

    xacro leaves `{name}` as it is: the name of a link or joint then holds the braces, and nothing that refers
    to it finds it.
    """
    yield from findings_of(project, ProblemKind.BRACES)
