"""UC007."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC007",
    severity=Severity.ERROR,
    authority="xacro/substitution_args.py _eval_arg(): ArgException; xacro reports 'Undefined substitution argument'",
    bad={
        "robot.xacro": """
            <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <link name="«$(arg prefix)base»"/>
            </robot>
        """,
    },
    good={
        "robot.xacro": """
            <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <xacro:arg name="prefix" default="my_"/>
              <link name="$(arg prefix)base"/>
            </robot>
        """,
    },
)
def undefined_argument(project: Project) -> Iterator[Finding]:
    """An argument or environment variable is used that has no value.

    `$(arg x)` needs an `<xacro:arg>` with a default before its use, or a value on the command line.
    """
    yield from findings_of(project, ProblemKind.UNDEFINED_ARGUMENT)
