"""UC980."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.fault import Severity, fault
from urdfctl.model.degrees import rotation_in_words
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER, marked


@fault(
    "UC980",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="urdf: rpy is in radians; urdfdom takes any number",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(REACHER, '<joint name="bend" type="revolute">', 'rpy="0 0.3 0"', 'rpy="0 20 0"'),
            "controllers.yaml": REACHER_CONTROLLER,
        },
        {
            "robot.urdf": marked(
                REACHER,
                '<link name="fore">',
                '<origin xyz="0 0 0.12"/><mass',
                '<origin xyz="0 0 0.12" rpy="0 0 45"/><mass',
            ),
            "controllers.yaml": REACHER_CONTROLLER,
        },
        {
            "robot.urdf": marked(
                REACHER,
                '<link name="fore">',
                '<origin xyz="0 0 0.12"/><geometry',
                '<origin xyz="0 0 0.12" rpy="0 0 45"/><geometry',
            ),
            "controllers.yaml": REACHER_CONTROLLER,
        },
        {
            "robot.urdf": marked(
                REACHER,
                '<link name="hand">',
                '<link name="hand">',
                '<link name="hand"><visual><origin rpy="0 0 -30"/><geometry><box size="0.03 0.03 0.06"/></geometry></visual>',
            ).replace('«<link name="hand">»', '«<link name="hand">»'),
            "controllers.yaml": REACHER_CONTROLLER,
        },
    ],
    good=[
        {"robot.urdf": REACHER, "controllers.yaml": REACHER_CONTROLLER},
        {"robot.urdf": REACHER.replace('rpy="0 0.3 0"', 'rpy="0 7.854 0"'), "controllers.yaml": REACHER_CONTROLLER},
    ],
)
def angles_in_degrees(part: str, angles: Sequence[float]) -> str:
    """Rotation that is most likely in degrees.

    The part is turned several times around, and points into a direction that nobody meant. Lint finds the same as UC168.
    """
    return rotation_in_words(part, angles)
