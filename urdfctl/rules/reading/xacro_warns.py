"""UC013."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC013",
    severity=Severity.WARNING,
    runtime="warns",
    authority="xacro/__init__.py: check_attrs() 'unknown attribute(s)', Table._setitem() 'redefining global symbol', and others",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:property name="width" value="1" unit="m"/>»
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="part" value="base"/>
                  <link name="${part}"/>
                </robot>
            """,
        },
    ],
)
def xacro_warns(project: Project) -> Iterator[Finding]:
    """Xacro prints a warning about an element.

    xacro prints it and goes on, but the result may be wrong. For example, it ignores an unknown attribute, and a
    redefined symbol hides another one.
    """
    yield from findings_of(project, ProblemKind.XACRO_WARNING)
