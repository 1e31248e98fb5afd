"""UC007."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC007",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/substitution_args.py _eval_arg(): ArgException; xacro reports 'Undefined substitution argument'",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <link name="«$(arg prefix)base»"/>
                  <xacro:arg name="side" default="left"/>
                  <xacro:property name="where" value="$(arg side)"/>
                </robot>
            """,
        },
    ],
    options=("side:=right",),
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:arg name="prefix" default="my_"/>
                  <link name="$(arg prefix)base"/>
                  <xacro:arg name="side" default="left"/>
                  <xacro:property name="where" value="$(arg side)"/>
                </robot>
            """,
        },
    ],
)
def undefined_argument(project: Project) -> Iterator[Finding]:
    """Argument or environment variable without a value.

    `$(arg x)` requires an `<xacro:arg>` with a default before its use, or a value on the command line. A description
    that is linted without arguments may need some: see UC030.
    """
    yield from findings_of(project, ProblemKind.UNDEFINED_ARGUMENT)
    yield from findings_of(project, ProblemKind.UNDEFINED_VARIABLE)
