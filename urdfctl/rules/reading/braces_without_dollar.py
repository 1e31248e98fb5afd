"""UC020."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import Place, SourceSpan


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
    for problem in project.of_kind(ProblemKind.BRACES):
        yield Finding(
            problem.at, problem.message, fix=Fix(problem.hint, tuple(_with_dollar(problem.at, problem.subject)))
        )


def _with_dollar(at: Place, name: str) -> Iterator[Edit]:
    text = at.span.text
    for match in re.finditer(rf"(?<!\$){{\s*{re.escape(name)}\s*}}", text):
        before = at.start + len(text[: match.start()].encode())
        yield Edit(SourceSpan(at.source, before, before), "$")
