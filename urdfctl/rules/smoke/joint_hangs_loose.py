"""UC988."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER, marked

_BEND = """<joint name="bend">
          <command_interface name="position"/><state_interface name="position"/><state_interface name="velocity"/>
        </joint>
        """
_YAML = REACHER_CONTROLLER.replace("turn, bend, reach", "turn, reach")


@fault(
    "UC988",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="gz-sim and Gazebo Classic let a joint that nothing commands move freely; robot_state_publisher takes it for 0 "
    "if nobody publishes it",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(REACHER, '<joint name="bend" type="revolute">').replace(_BEND, ""),
            "controllers.yaml": _YAML,
        },
    ],
    good=[{"robot.urdf": REACHER, "controllers.yaml": REACHER_CONTROLLER}],
)
def joint_hangs_loose(joint: str, link: str, weight: float, unit: str) -> str:
    """Joint that nothing commands or holds.

    No controller and no hardware commands it, no transmission moves it and no plugin names it, so that it falls while
    the joints around it are held. Add it to the hardware and to a controller, or make it fixed.
    """
    return f"nothing commands or holds joint '{joint}', and link '{link}' pulls at it with up to {weight:.3g} {unit}: it falls"
