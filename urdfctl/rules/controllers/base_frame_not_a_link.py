"""UC445."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import Reader, in_each_distro, robot_of
from urdfctl.model.controllers import ValueKind
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import KnownNames, replaced
from urdfctl.source.span import Place

_BASE = """
    states: {type: joint_state_controller/JointStateController, publish_rate: 50}
    base:
      type: diff_drive_controller/DiffDriveController
      left_wheel: shoulder
      right_wheel: elbow
      wheel_separation: 0.4
      wheel_radius: 0.1
      pose_covariance_diagonal: [0.001, 0.001, 0.001, 0.001, 0.001, 0.03]
      twist_covariance_diagonal: [0.001, 0.001, 0.001, 0.001, 0.001, 0.03]
      base_frame_id: %s
"""
_DRIVES = """
    <transmission name="left">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="shoulder"><hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>
      <actuator name="left_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
    <transmission name="right">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>
      <actuator name="right_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
"""


@rule(
    "UC445",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="diff_drive_controller and similar types publish the transform from odom to base_frame_id without checking "
    "it against the robot description",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad=[{"robot.urdf": _DRIVES, "controllers.yaml": _BASE % "«base_lnk»"}],
    good=[{"robot.urdf": _DRIVES, "controllers.yaml": _BASE % "base"}],
)
def base_frame_not_a_link(project: Project) -> Iterator[Finding]:
    """Base frame is not a link of the robot.

    The drive publishes its odometry for a frame that no link is attached to, unless another node connects the two. RViz
    then shows the robot standing still, and there is no transform from the odometry frame to the robot.
    """
    robot = robot_of(project)
    if robot is not None:
        names = KnownNames(link.name for link in robot.links)
        yield from in_each_distro(project, lambda reader: _missing_frame(reader, names))


def _missing_frame(reader: Reader, names: KnownNames) -> Iterator[Finding]:
    parameter, given = reader.known.get("base_frame_id"), reader.located.get("base_frame_id")
    if parameter is None or reader.at is None:
        return
    if given is None:
        yield from _missing_default(reader, reader.at, str(parameter.default or ""), names)
        return
    if given.value.kind is not ValueKind.STRING or not given.value.is_known or not given.value.text:
        return
    name = given.value.text.rpartition("/")[2]
    if name in names or given.value.text.strip("/") in names:
        return
    right = names.meant_by(name)
    hint = f"; did you mean '{right}'?" if right else ""
    fix = replaced(given.value.at, name, right) if right else None
    message = f"'base_frame_id' is '{given.value.text}', but the robot has no such link{hint}"
    yield Finding(given.value.at, message, fix=fix, severity=Severity.WARNING)


def _missing_default(reader: Reader, at: Place, default: str, names: KnownNames) -> Iterator[Finding]:
    """A finding at the section of a drive that takes its base frame from a default."""
    if default and default not in names and reader.given.get("enable_odom_tf") is not False:
        message = (
            f"controller '{reader.name}' has no 'base_frame_id', and the robot has no link '{default}' (its default)"
        )
        yield Finding(
            at, message, (Note("add base_frame_id with the name of the base link"),), severity=Severity.WARNING
        )
