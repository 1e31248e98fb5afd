"""UC977."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER

_FOOT = '<collision><origin xyz="%s 0 0"/><geometry><box size="0.1 0.1 0.02"/></geometry></collision>'
_LOOSE = GRIPPER.replace(
    '<joint name="bench" type="fixed"><parent link="world"/><child link="palm"/></joint>', ""
).replace('<link name="world"/>', "")
_SIMULATED = _LOOSE.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")


@fault(
    "UC977",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="gazebo: a model whose URDF has no link 'world' is free; it tips where its centre of mass is not over its base",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": _SIMULATED.replace('<robot name="gripper">', '«<robot name="gripper">»').replace(
                '<link name="palm">', f'<link name="palm">{_FOOT % 0.2}'
            ),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER}],
)
def loose_robot_tips_over(when: str) -> str:
    """Robot that nothing fixes to the world tips over.

    Gazebo puts a robot without a link `world` on the ground. In some pose its centre of mass is not over the part of its
    base that touches the ground, so it falls. Many arms are meant to be bolted to a table: fix the base to a link
    `world` then.
    """
    return (
        f"the robot tips over on flat ground {when}: nothing fixes it to the world. If its base is bolted "
        "down, add a link 'world' and a fixed joint to it"
    )
