"""UC474."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from urdfctl.catalog.distros import ROS1, since
from urdfctl.control.claims import claims
from urdfctl.control.parameters.readers import Reader, in_each_distro, robot_of
from urdfctl.control.session import readable
from urdfctl.model.robot import Joint
from urdfctl.rule import Finding, Note, Project, Severity, rule

_WHEELS = """
    <ros2_control name="base" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder">
        <command_interface name="velocity"/><state_interface name="position"/><state_interface name="velocity"/>
      </joint>
      <joint name="elbow">
        <command_interface name="velocity"/><state_interface name="position"/><state_interface name="velocity"/>
      </joint>
    </ros2_control>
"""
_DRIVE = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        drive: {type: diff_drive_controller/DiffDriveController}
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
    drive:
      ros__parameters:
        left_wheel_names: [shoulder]
        right_wheel_names: [elbow]
        wheel_separation: 0.4
        wheel_radius: 0.1
        base_frame_id: base
        linear.x: {max_velocity: %s}
"""
_SLACK = 1.02
"""Limits are rounded: a wheel may exceed its limit by this factor."""


@rule(
    "UC474",
    severity=Severity.WARNING,
    runtime="misbehaves",
    distros=(*ROS1, *since("kilted")),
    authority="joint_limits_interface VelocityJointSaturationHandle and, with enforce_command_limits (default since kilted), "
    "ros2_control's joint_limits clamp the command of each joint to the URDF's velocity",
    whole_robot=True,
    in_library=False,
    options=["--distro=kilted"],
    bad=[{"robot.urdf": _WHEELS, "controllers.yaml": _DRIVE % "«1.5»"}],
    good=[{"robot.urdf": _WHEELS, "controllers.yaml": _DRIVE % "0.2"}],
)
def wheel_speed_beyond_limit(project: Project) -> Iterator[Finding]:
    """Speed of a drive needs wheels that turn faster than their joints may.

    A wheel turns at the robot's speed divided by its radius. Its command is clamped to the joint's velocity limit: the
    robot is slower than commanded, and drives another curve if only one wheel is clamped.
    """
    robot = robot_of(project)
    if robot is not None:
        joints = {joint.name or "": joint for joint in robot.joints}
        yield from in_each_distro(project, lambda reader: _too_fast(reader, joints))


def _too_fast(reader: Reader, joints: Mapping[str, Joint]) -> Iterator[Finding]:
    radius, separation = _number(reader, "wheel_radius"), _number(reader, "wheel_separation")
    limits = [(limit, joints[name]) for name, limit in _limits(reader, joints).items()]
    if not radius or not limits:
        return
    limit, joint = min(limits, key=lambda one: one[0])
    for parameter, arm in (("linear.x", 1.0), ("angular.z", (separation or 0) / 2)):
        speed = _greatest(reader, parameter)
        turning = speed * arm / radius if speed else 0.0
        at = reader.located.value(f"{parameter}.max_velocity")
        if at is None or turning <= limit * _SLACK:
            continue
        unit = "m/s" if parameter == "linear.x" else "rad/s"
        message = (
            f"at {speed:g} {unit} the wheels turn at {turning:.3g} rad/s, but joint '{joint.name}' may only turn at "
            f"{limit:g} rad/s. Reduce '{parameter}.max_velocity' to {limit * radius / arm:.3g}, or raise the joint's limit"
        )
        notes = (
            (Note("the joint's limit is here", joint.limit.velocity.at),)
            if joint.limit and joint.limit.velocity
            else ()
        )
        yield Finding(at.at, message, notes, severity=Severity.WARNING)
        return


def _limits(reader: Reader, joints: Mapping[str, Joint]) -> dict[str, float]:
    """The velocity limits of the wheels by name, in rad/s. A limit of 0 has a rule of its own."""
    claimed = claims(reader.type, reader.name, readable(reader.type, reader.given)) if reader.type else None
    wheels = [claim.component for claim in claimed.command if claim.component in joints] if claimed else []
    found = {}
    for name in wheels:
        limit = joints[name].limit
        value = limit.velocity.value if limit and limit.velocity else None
        if value and math.isfinite(value):
            found[name] = value
    return found


def _greatest(reader: Reader, parameter: str) -> float | None:
    """The greatest speed that the drive allows; None without a limit."""
    if reader.given.get(f"{parameter}.has_velocity_limits") is False:
        return None
    return _number(reader, f"{parameter}.max_velocity")


def _number(reader: Reader, parameter: str) -> float | None:
    value = reader.given.get(parameter) if parameter in reader.known else None
    return (
        float(value)
        if isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
        else None
    )
