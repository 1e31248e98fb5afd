"""UC445."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.parameters import Kind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import Names, replaced
from urdfctl.rules.controllers.joints import robot_of
from urdfctl.rules.controllers.readers import Reader, in_each_distro

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
    severity=Severity.WARNING,
    authority="diff_drive_controller and its like publish the transform from odom to base_frame_id, and compare it with no "
    "description",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad={"robot.urdf": _DRIVES, "controllers.yaml": _BASE % "«base_lnk»"},
    good={"robot.urdf": _DRIVES, "controllers.yaml": _BASE % "base"},
)
def base_frame_not_a_link(project: Project) -> Iterator[Finding]:
    """The base frame of a drive is no link of the robot.

    The odometry moves a frame that nothing hangs on, unless something else joins the two: the robot stands still where
    it is shown, and is not found in the odometry's frame.
    """
    robot = robot_of(project)
    if robot is not None:
        names = Names(link.name for link in robot.links)
        yield from in_each_distro(project, lambda reader: _elsewhere(reader, names))


def _elsewhere(reader: Reader, names: Names) -> Iterator[Finding]:
    given = reader.located.get("base_frame_id") if "base_frame_id" in reader.known else None
    if given is None or given.value.kind is not Kind.STRING or not given.value.is_known or not given.value.text:
        return
    name = given.value.text.rpartition("/")[2]
    if name in names:
        return
    right = names.meant_by(name)
    end = f"; did you mean '{right}'?" if right else ""
    fix = replaced(given.value.at, name, right) if right else None
    message = f"'base_frame_id' is '{given.value.text}', which is no link of the robot{end}"
    yield Finding(given.value.at, message, fix=fix, severity=Severity.WARNING)
