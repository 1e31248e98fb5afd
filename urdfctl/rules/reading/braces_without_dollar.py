"""UC020."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import Place, SourceSpan


@rule(
    "UC020",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="xacro/__init__.py LEXER: an expression is '$' followed by '{'",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="side" value="left"/>
                  <link name="«{side}_wheel»"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="side" value="left"/>
                  <link name="${side}_wheel"/>
                </robot>
            """,
        },
    ],
)
def braces_without_dollar(project: Project) -> Iterator[Finding]:
    """Property name in braces without `$`.

    xacro copies `{name}` unchanged. The name of the link or joint then contains the braces, and references to it fail.
    """
    for problem in project.of_kind(ProblemKind.BRACES):
        yield Finding(
            problem.at, problem.message, fix=Fix(problem.hint, tuple(_with_dollar(problem.at, problem.subject)))
        )


def _with_dollar(at: Place, name: str) -> Iterator[Edit]:
    text = at.span.text
    for match in re.finditer(rf"(?<!\$){{\s*{re.escape(name)}\s*}}", text):
        before = at.start + len(text[: match.start()].encode())
        yield Edit(SourceSpan(at.source, before, before), "$")
