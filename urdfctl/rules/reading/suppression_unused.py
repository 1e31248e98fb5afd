"""UC099."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule


@rule(
    "UC099",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="urdfctl itself: an unused suppression may hide the next fault",
    bad={
        "robot.urdf": """
            <robot name="r">
              <!-- «urdfctl: ignore[UC001]» it was broken once -->
              <link name="base"/>
            </robot>
        """,
    },
    good={
        "robot.urdf": """
            <robot name="r">
              <link name="base"/>
            </robot>
        """,
    },
)
def suppression_unused(project: Project) -> Iterator[Finding]:
    """Unused suppression.

    The comment has no effect. The finding was fixed, or the comment is on the wrong line. A comment applies to its own
    line and the next one. Place it at the finding, at the macro's definition or at the macro's call.
    """
    del project  # the engine makes these findings: it knows what the other rules found, in all robots of the run
    return iter(())
