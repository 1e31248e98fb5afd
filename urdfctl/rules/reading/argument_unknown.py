"""UC021."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC021",
    severity=Severity.WARNING,
    runtime="ignores",
    options=("prefx:=left_",),
    authority="xacro/cli.py load_mappings(): every name:=value is kept; nothing compares them with <xacro:arg>",
    bad={
        "robot.xacro": """
            «<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">»
              <xacro:arg name="prefix" default=""/>
              <link name="$(arg prefix)base"/>
            </robot>
        """,
    },
    good={
        "robot.xacro": """
            <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
              <xacro:arg name="prefx" default=""/>
              <link name="$(arg prefx)base"/>
            </robot>
        """,
    },
)
def argument_unknown(project: Project) -> Iterator[Finding]:
    """Argument that the description does not declare.

    xacro accepts any `name:=value` and does not report one that no `$(arg name)` uses. The robot is expanded with the
    default value.
    """
    yield from findings_of(project, ProblemKind.UNKNOWN_ARGUMENT)
