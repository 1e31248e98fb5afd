"""UC000."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule


@rule(
    "UC000",
    runtime="crashes",
    severity=Severity.ERROR,
    authority="urdfctl itself: a rule must never raise",
    bad={},
    good={},
)
def rule_crashed(project: Project) -> Iterator[Finding]:
    """A rule of urdfctl crashed on this robot.

    The other rules ran, and their findings are valid. The exit status is 3. Please report the crash, with the robot if
    possible.
    """
    del project  # the engine makes these findings when a rule raises
    return iter(())
