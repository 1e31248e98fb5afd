"""UC001."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC001",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/model.cpp: parseURDF() returns nothing when tinyxml cannot parse; xacro/__init__.py: 'XML parsing error'",
    bad=[
        {
            "robot.urdf": """
                <robot name="r">
                  <link name="base">
                «</robot>»
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <robot name="r">
                  <link name="base"/>
                </robot>
            """,
        },
    ],
)
def xml_not_well_formed(project: Project) -> Iterator[Finding]:
    """File is not well-formed XML.

    robot_state_publisher, Gazebo and the controller manager all reject the whole description. One case is only a
    warning: urdfdom accepts blanks before the XML declaration, but xacro does not.
    """
    yield from findings_of(project, ProblemKind.XML_SYNTAX)
    for finding in findings_of(project, ProblemKind.LATE_DECLARATION):
        yield finding._replace(severity=Severity.WARNING)
