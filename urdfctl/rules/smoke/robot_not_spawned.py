"""UC901."""

from __future__ import annotations

from urdfctl.fault import Severity, Stage, fault
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE


@fault(
    "UC901",
    stage=Stage.SPAWN,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom: 'Failed to build tree'; Gazebo, robot_state_publisher and the controller manager all "
    "refuse such a description",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": HARDWARE
            + '<joint name="spare" type="fixed"><parent link="fore"/><child link="«tool»"/></joint>',
            "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]"),
        },
    ],
    good=[{"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")}],
)
def robot_not_spawned(why: str) -> str:
    """Robot cannot be spawned.

    The robot description is rejected, so no controller is loaded. The smoke test reports the first error of the
    description; `urdfctl lint` reports all of them.
    """
    return f"the robot cannot be spawned: {why}"
