"""UC016."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC016",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="xacro/__init__.py process_include() and load_yaml(): open any path they are given",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:include filename="/etc/hostname"/>»
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:include filename="wheel.xacro"/>
                </robot>
            """,
            "wheel.xacro": """
                <robot><link name="base"/></robot>
            """,
        },
    ],
)
def outside_workspace(project: Project) -> Iterator[Finding]:
    """File outside the workspace.

    A robot from an untrusted source must not read other files on this machine. urdfctl reads files in the workspace, in
    the packages that it resolves, and in `--package-path`, and refuses others. Use `--workspace` to widen this, or
    `--trust` to turn the check off.
    """
    yield from findings_of(project, ProblemKind.OUTSIDE_WORKSPACE)
