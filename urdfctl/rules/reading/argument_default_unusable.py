"""UC028."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC028",
    severity=Severity.WARNING,
    runtime="refuses",
    because="whoever passes the argument starts the robot",
    authority="xacro/__init__.py load_yaml(), parse(): the folder of the file at work, opened as a file: 'Is a directory'; "
    "xacro/substitution_args.py _eval_arg(): 'Undefined substitution argument' without a default",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:arg name="«tool»" default=""/>
                  <xacro:include filename="$(arg tool)"/>
                  <link name="$(arg prefix)base"/>
                </robot>
            """,
        },
    ],
    options=("prefix:=my_",),
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:arg name="tool" default="tool.xacro"/>
                  <xacro:include filename="$(arg tool)"/>
                  <link name="$(arg prefix)base"/>
                </robot>
            """,
            "tool.xacro": '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>',
        },
    ],
)
def argument_default_unusable(project: Project) -> Iterator[Finding]:
    """Empty default for an argument that a file name needs.

    The description looks as if it expands without the argument, but it does not. xacro tries to open a folder, or a
    file without a name, and its error does not mention the argument. Without the default, xacro names the missing
    argument.
    """
    yield from findings_of(project, ProblemKind.ARGUMENT_UNUSABLE)
