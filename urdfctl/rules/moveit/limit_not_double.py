"""UC667."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.moveit.samples import LIMITS, planned
from urdfctl.source.yaml.kinds import ValueKind
from urdfctl.source.yaml.types import typed_by_rcl

_NEEDED_BY = {
    "max_velocity": "has_velocity_limits",
    "max_acceleration": "has_acceleration_limits",
    "max_jerk": "has_jerk_limits",
}
_ALWAYS = ("max_position", "min_position")


@rule(
    "UC667",
    runtime="crashes",
    severity=Severity.ERROR,
    distros=since("humble"),
    options=("--distro=humble",),
    authority="moveit_ros_planning robot_model_loader.cpp configure(): declare_parameter(..., PARAMETER_DOUBLE); rclcpp: "
    "\"parameter 'robot_description_planning.joint_limits.elbow.max_velocity' has invalid type: expected [double] got [integer]\"",
    bad=[
        planned(joint_limits=LIMITS.replace("max_acceleration: 2.0", "max_acceleration: «2»", 1)),
        planned(
            joint_limits="""
                joint_limits:
                  shoulder: {has_velocity_limits: true, max_velocity: «1», has_jerk_limits: true, max_jerk: «5»}
                  elbow: {max_position: «1», min_position: «-1», has_velocity_limits: false, max_velocity: 1}
            """
        ),
    ],
    good=[planned(joint_limits=LIMITS)],
)
def limit_not_double(project: Project) -> Iterator[Finding]:
    """Joint limit is an integer.

    MoveIt declares each limit as a double, and ROS 2 does not convert integers. move_group ends with an exception.
    """
    for limits in project.moveit.limits if project.moveit else ():
        for key, value in limits.values:
            flag = limits.value(_NEEDED_BY.get(key.text, ""))
            is_read = key.text in _ALWAYS or (flag is not None and flag.text.lower() == "true")
            if is_read and typed_by_rcl(value).kind is ValueKind.INT:
                fix = Fix(f"write {value.text}.0", (Edit(value.at.span, f"{value.text}.0"),), safe=True)
                message = f"'{key.text}' of joint '{limits.joint.text}' must be a double: write {value.text}.0"
                yield Finding(value.at, message, (), fix)
