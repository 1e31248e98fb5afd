"""UC023."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC023",
    runtime="refuses",
    because="a built workspace may have the package",
    severity=Severity.WARNING,
    authority="colcon-ros and catkin_pkg: a package is a folder that holds a package.xml (REP 149)",
    bad=[
        {
            "my_description/robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  «<xacro:include filename="$(find my_description)/wheel.xacro"/>»
                </robot>
            """,
            "my_description/wheel.xacro": """
                <robot><link name="base"/></robot>
            """,
        },
    ],
    good=[
        {
            "my_description/robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:include filename="$(find my_description)/wheel.xacro"/>
                </robot>
            """,
            "my_description/wheel.xacro": """
                <robot><link name="base"/></robot>
            """,
            "my_description/package.xml": """
                <package format="3"><name>my_description</name></package>
            """,
        },
    ],
)
def package_without_manifest(project: Project) -> Iterator[Finding]:
    """Package without package.xml.

    colcon and catkin ignore a folder without a package.xml, and `$(find pkg)` fails when the robot is started. urdfctl
    uses the folder of that name instead, so that it can check the rest.
    """
    yield from findings_of(project, ProblemKind.MANIFEST_MISSING)
