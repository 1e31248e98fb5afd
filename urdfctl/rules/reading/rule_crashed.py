"""UC000."""

from __future__ import annotations

from urdfctl.fault import Severity, fault


@fault(
    "UC000",
    runtime="crashes",
    severity=Severity.ERROR,
    authority="urdfctl itself: a rule must never raise",
    bad=[],
    good=[],
)
def rule_crashed(what: str, why: str) -> str:
    """A rule of urdfctl crashed on this robot.

    The other rules ran, and their findings are valid. The exit status is 3. Please report the crash, with the robot if
    possible.
    """
    return f"{what} crashed: {why}"
