"""UC160."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Limit, Mimic, Number
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import label, robot_in

_FINGER = """
    <link name="finger">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <joint name="thumb" type="revolute">
      <parent link="fore"/><child link="finger"/>
      <limit lower="-1" upper="1" effort="10" velocity="4"/>
      %s
    </joint>
"""
_SLACK = 0.02
"""Limits are rounded: a joint may exceed its range by this fraction of it."""


@rule(
    "UC160",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="wiki.ros.org urdf/XML/joint: value = multiplier * other_joint_value + offset, and limits hold for each joint; "
    "urdfdom joint.cpp does not compare them",
    bad=[{"robot.urdf": _FINGER % '«<mimic joint="elbow" multiplier="2"/>»'}],
    good=[{"robot.urdf": _FINGER % '<mimic joint="elbow" multiplier="-1"/>'}],
)
def mimic_range_beyond_limits(project: Project) -> Iterator[Finding]:
    """Mimic joint would exceed its limits.

    Nothing compares the two joints. Where the other joint goes, this one cannot follow: simulators stop it at its limit,
    so that it holds the other joint or loses it, and planners reject such positions.
    """
    robot = robot_in(project)
    joints = {joint.name: joint for joint in robot.joints} if robot else {}
    for joint in joints.values():
        mimic = joint.mimic
        leader = joints.get(mimic.joint) if mimic else None
        if mimic is None or leader is None or leader is joint or "continuous" in (leader.type, joint.type):
            continue
        own, asked = _range(joint.limit), _asked(mimic, _range(leader.limit))
        if own is None or asked is None:
            continue
        slack = _SLACK * (own[1] - own[0])
        if asked[0] < own[0] - slack or asked[1] > own[1] + slack:
            message = (
                f"{label('joint', joint.name)} follows joint '{leader.name}' from {asked[0]:.3g} to {asked[1]:.3g}, but its "
                f"own limits are {own[0]:g} and {own[1]:g}; correct the limits or the multiplier"
            )
            notes = (Note(f"the limits of '{leader.name}' are here", leader.limit.at),) if leader.limit else ()
            yield Finding(mimic.at, message, notes)


def _range(limit: Limit | None) -> tuple[float, float] | None:
    """The lower and upper limit; None if one is unknown, or if they leave no range."""
    lower, upper = (_value(limit.lower, 0), _value(limit.upper, 0)) if limit else (None, None)
    return (lower, upper) if lower is not None and upper is not None and lower < upper else None


def _asked(mimic: Mimic, leader: tuple[float, float] | None) -> tuple[float, float] | None:
    """The lowest and highest position that the joint is to follow to."""
    multiplier, offset = _value(mimic.multiplier, 1), _value(mimic.offset, 0)
    if leader is None or multiplier is None or offset is None:
        return None
    one, other = (multiplier * end + offset for end in leader)
    return min(one, other), max(one, other)


def _value(number: Number | None, default: float) -> float | None:
    return default if number is None else number.value
