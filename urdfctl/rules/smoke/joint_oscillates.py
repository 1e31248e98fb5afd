"""UC933."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT

_CHAIN = """
    controller_manager:
      ros__parameters:
        update_rate: 500
        mover: {type: forward_command_controller/ForwardCommandController}
        loop: {type: pid_controller/PidController}
    mover:
      ros__parameters:
        joints: [loop/lift]
        interface_name: position
    loop:
      ros__parameters:
        dof_names: [lift]
        command_interface: effort
        reference_and_state_interfaces: [position]
        gains:
          lift: {p: 4000.0, i: 0.0, d: 1.0}
"""


@fault(
    "UC933",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace(
                '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
            ),
            "controllers.yaml": _CHAIN,
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joint_oscillates(controller: str, joint: str, swing: float, unit: str) -> str:
    """Joint oscillates at its target.

    The gains of its control loop are too high, or nothing damps the joint.
    """
    return f"controller '{controller}': joint '{joint}' swings by {swing:.3g} {unit} where it should stand still"
