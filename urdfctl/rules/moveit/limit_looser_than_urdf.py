"""UC669."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.moveit import JointLimits
from urdfctl.model.robot import Joint
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.moveit.samples import LIMITS, planned

_TOLERANCE = 1e-3


@rule(
    "UC669",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="moveit_ros_planning robot_model_loader.cpp configure(): limits in joint_limits.yaml replace those of the URDF; the "
    "setup assistant writes: 'Joint limits can be turned off with has_velocity_limits' and expects tighter ones",
    bad=[planned(joint_limits=LIMITS.replace("max_velocity: 1.5", "max_velocity: «15.0»", 1))],
    good=[planned(joint_limits=LIMITS)],
)
def limit_looser_than_urdf(project: Project) -> Iterator[Finding]:
    """joint_limits.yaml allows more than the URDF.

    MoveIt replaces the limit of the URDF. It plans motions that the hardware or the controller, which read the URDF, do
    not follow.
    """
    robot = whole_robot_in(project)
    for limits in project.moveit.limits if project.moveit and robot else ():
        joint = robot.joint(limits.joint.text) if robot else None
        if joint is not None and joint.limit is not None:
            yield from _compared(limits, joint)


def _compared(limits: JointLimits, joint: Joint) -> Iterator[Finding]:
    given = joint.limit
    if given is None:
        return
    flag = limits.value("has_velocity_limits")
    is_read = flag is not None and flag.text.lower() == "true"
    pairs = (
        ("max_velocity", given.velocity, 1, is_read),
        ("max_position", given.upper, 1, joint.type in ("revolute", "prismatic")),
        ("min_position", given.lower, -1, joint.type in ("revolute", "prismatic")),
    )
    for name, number, sign, counts in pairs:
        value = limits.value(name)
        ours, theirs = _float(value.text) if value else None, number.value if number else None
        if (
            counts
            and value
            and number
            and ours is not None
            and theirs is not None
            and ours * sign > theirs * sign + _TOLERANCE
        ):
            message = f"'{name}' of joint '{limits.joint.text}' is {value.text}, but the URDF allows {number.text}"
            yield Finding(value.at, message, (Note("the URDF limits it here", number.at),))


def _float(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None
