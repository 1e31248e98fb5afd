"""UC030."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC030",
    severity=Severity.INFO,
    runtime="refuses",
    because="a launch file passes the arguments",
    authority="xacro/substitution_args.py _eval_arg(): without a value xacro reports 'Undefined substitution argument'",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:arg name="«tool»" default=""/>
                  <xacro:include filename="$(arg tool).xacro"/>
                  <link name="$(arg prefix)base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:arg name="prefix" default="my_"/>
                  <link name="$(arg prefix)base"/>
                </robot>
            """,
        },
    ],
)
def arguments_needed(project: Project) -> Iterator[Finding]:
    """Description needs arguments.

    It uses arguments that have no default, or only an empty one that makes xacro fail. This is no fault: a launch file
    passes them. To check the whole robot, lint that launch file, pass the arguments, or write them into a [[robot]] of
    urdfctl.toml. Until then, their values are unknown.
    """
    yield from findings_of(project, ProblemKind.ARGUMENTS_NEEDED)
