"""UC165."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Joint, Tag
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in

_WRIST = """
    <link name="tool">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <joint name="wrist" type="revolute">
      <parent link="fore"/><child link="tool"/>
      <limit lower="-1" upper="1" effort="5" velocity="2"/>
      <safety_controller %s/>
    </joint>
"""
_SOFT = 'k_velocity="10" k_position="10" soft_lower_limit="%s" soft_upper_limit="%s"'


@rule(
    "UC165",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="urdfdom urdf_parser/src/joint.cpp parseJointSafety() takes every number; joint_limits_interface "
    "joint_limits_interface.h EffortJointSoftLimitsHandle::enforceLimits(): effort bound = -k_velocity * (velocity - bound)",
    bad=[
        {"robot.urdf": _WRIST % 'k_velocity="«-10»"'},
        {"robot.urdf": _WRIST % 'k_velocity="«0»"'},
        {"robot.urdf": _WRIST % 'k_velocity="1" k_position="«-3»"'},
        {"robot.urdf": _WRIST % (_SOFT % ("«0.5»", "-0.5"))},
        {"robot.urdf": _WRIST % (_SOFT % ("-0.5", "«3»"))},
        {"robot.urdf": _WRIST % (_SOFT % ("«-3»", "0.5"))},
    ],
    good=[{"robot.urdf": _WRIST % (_SOFT % ("-0.9", "0.9"))}],
)
def safety_stops_joint(project: Project) -> Iterator[Finding]:
    """<safety_controller> with values that stop the joint, or protect nothing.

    urdfdom accepts them. With k_velocity 0 the effort is bounded to 0, and a negative gain pushes the joint on. Soft
    limits that are reversed leave no range, and those outside of the limits never act.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        safety = next(joint.tag.named("safety_controller"), None)
        if safety is not None:
            yield from _of_gains(joint, safety)
            yield from _of_range(joint, safety)


def _of_gains(joint: Joint, safety: Tag) -> Iterator[Finding]:
    name = label("joint", joint.name)
    for gain in ("k_velocity", "k_position"):
        value = _number(safety, gain)
        if value is not None and (value < 0 or (value == 0 and gain == "k_velocity")):
            what = "bounds the effort to 0" if value == 0 else "pushes the joint on"
            yield Finding(safety.at[gain], f"{gain} {value:g} of the <safety_controller> of {name} {what}")


def _of_range(joint: Joint, safety: Tag) -> Iterator[Finding]:
    name = label("joint", joint.name)
    low, high = _number(safety, "soft_lower_limit"), _number(safety, "soft_upper_limit")
    if low is None or high is None or joint.type not in ("revolute", "prismatic"):
        return
    if low > high:
        message = f"soft_lower_limit of {name} is {low:g}, but soft_upper_limit is {high:g}"
        yield Finding(safety.at["soft_lower_limit"], message)
        return
    limit = next(joint.tag.named("limit"), None)
    lower, upper = (_number(limit, "lower"), _number(limit, "upper")) if limit else (None, None)
    outside = (
        ("soft_lower_limit", lower is not None and low < lower),
        ("soft_upper_limit", upper is not None and high > upper),
    )
    for attribute, is_outside in outside:
        if is_outside:
            yield Finding(safety.at[attribute], f"{attribute} of {name} is outside of its limits, so it never acts")


def _number(tag: Tag, name: str) -> float | None:
    text = tag.attributes.get(name, "")
    try:
        return float(text) if is_known(text) else None
    except ValueError:
        return None
