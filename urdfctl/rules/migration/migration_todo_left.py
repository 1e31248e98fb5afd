"""UC708."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule


@rule(
    "UC708",
    runtime="works",
    because="the migration is not finished",
    severity=Severity.WARNING,
    in_library=True,
    authority="urdfctl migrate: the comment that it writes where a person must decide",
    bad=[
        {
            "robot.urdf": """
                <gazebo reference="fore">
                  <!-- «TODO(urdfctl): 'libarm_extra.so' has no known successor in gz» -->
                  <mu1>0.9</mu1>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <gazebo reference="fore">
                  <!-- TODO: measure it -->
                  <mu1>0.9</mu1>
                </gazebo>
            """,
        },
    ],
)
def migration_todo_left(project: Project) -> Iterator[Finding]:
    """Migration leaves a decision open.

    `urdfctl migrate` writes such a comment where the files do not say what to do. Decide, then remove the comment.
    """
    for text, at in project.todos:
        yield Finding(at, f"left by the migration: {text}")
