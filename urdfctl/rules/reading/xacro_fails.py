"""UC012."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC012",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py and xmlutils.py: check_attrs(), reqd_attrs(), grab_property(), grab_macro()",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:property name="2nd" value="1"/>»
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="second" value="base"/>
                  <link name="${second}"/>
                </robot>
            """,
        },
    ],
)
def xacro_fails(project: Project) -> Iterator[Finding]:
    """Xacro cannot process an element.

    The element lacks an attribute, has a name that is not an identifier, or gives a property two values. xacro stops
    there.
    """
    yield from findings_of(project, ProblemKind.XACRO)
