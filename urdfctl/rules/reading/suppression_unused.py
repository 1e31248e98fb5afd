"""UC099."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule


@rule(
    "UC099",
    severity=Severity.WARNING,
    authority="urdfctl itself: a comment that silences nothing may hide the next fault",
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
    """A comment ignores findings that there are none of.

    The fault was mended, or the comment stands on the wrong line: it speaks of its own line and the next, at the finding,
    at the macro's definition or at its call.
    """
    del project  # the engine makes these findings: it knows what the other rules found, in all robots of the run
    return iter(())
