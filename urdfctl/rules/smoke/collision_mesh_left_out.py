"""UC922."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC922",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace(
                '<link name="base_link"/>',
                '«<link name="base_link">»<collision><geometry><mesh filename="wheel.obj"/></geometry></collision></link>',
            ),
            "controllers.yaml": GAINS % "mover",
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def collision_mesh_left_out(link: str, more: str, why: str) -> str:
    """Collision geometry cannot be simulated.

    The mesh is missing or broken. Some broken meshes crash physics engines, so the robot is simulated without it. A
    wheel gets a cylinder with the radius that its controller uses.
    """
    return f"the collision geometry of link '{link}' is ignored{more}: {why}"
