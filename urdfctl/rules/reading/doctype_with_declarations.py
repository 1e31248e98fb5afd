"""UC005."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC005",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="CWE-776: recursive entity expansion; tinyxml, which urdfdom uses, knows no entities of a document's own",
    bad=[
        {
            "robot.urdf": """
                «<!DOCTYPE» robot [<!ENTITY mass "1.0">]>
                <robot name="r">
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <!DOCTYPE robot>
                <robot name="r">
                  <link name="base"/>
                </robot>
            """,
        },
    ],
)
def doctype_with_declarations(project: Project) -> Iterator[Finding]:
    """DOCTYPE with entity declarations.

    Entities that refer to each other can expand to an unlimited size. urdfctl also reads files that you do not trust,
    so it rejects such a DOCTYPE. `--trust` accepts it.
    """
    yield from findings_of(project, ProblemKind.DOCTYPE)
