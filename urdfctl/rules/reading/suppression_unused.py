"""UC099."""

from __future__ import annotations

from urdfctl.fault import Severity, fault


@fault(
    "UC099",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="urdfctl itself: an unused suppression may hide the next fault",
    bad=[
        {
            "robot.urdf": """
                <robot name="r">
                  <!-- «urdfctl: ignore[UC001]» it was broken once -->
                  <link name="base"/>
                </robot>
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
def suppression_unused(codes: str) -> str:
    """Unused suppression.

    The comment has no effect. The finding was fixed, or the comment is on the wrong line. A comment applies to its own
    line and the next one. Place it at the finding, at the macro's definition or at the macro's call.
    """
    return f"unused suppression: there is no finding of {codes} on this line or the next"
