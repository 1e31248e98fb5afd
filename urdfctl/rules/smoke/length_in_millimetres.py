"""UC981."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER, marked


@fault(
    "UC981",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="REP 103: lengths are in metres; urdf: <origin>, <box>, <cylinder>, <sphere> and meshes are in metres",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(REACHER, '<link name="hand">', 'box size="0.03 0.03 0.06"', 'box size="30 30 60"'),
            "controllers.yaml": REACHER_CONTROLLER,
        },
        {
            "robot.urdf": marked(REACHER, '<joint name="reach" type="prismatic">', 'xyz="0 0 0.24"', 'xyz="0 0 240"'),
            "controllers.yaml": REACHER_CONTROLLER,
        },
        {
            "robot.urdf": marked(
                REACHER, '<link name="fore">', '<origin xyz="0 0 0.12"/><mass', '<origin xyz="0 0 120"/><mass'
            ),
            "controllers.yaml": REACHER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": REACHER, "controllers.yaml": REACHER_CONTROLLER}],
)
def length_in_millimetres(part: str, length: float, usual: float) -> str:
    """Length that is most likely in mm.

    It is a hundred times as long as the links of the robot usually are. Of a mesh in mm, give the scale
    `0.001 0.001 0.001`.
    """
    return (
        f"{part} {length:.3g} m, but the links of this robot are {usual:.2g} m long: most likely millimetres; "
        f"in m it is {length / 1000:.3g}"
    )
