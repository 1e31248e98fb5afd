"""UC462."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.claims.common import of_each_candidate, place_of
from urdfctl.rules.claims.ros1 import bare, mended_severity, unregistered
from urdfctl.rules.common import in_words

_ROBOT = """
    <transmission name="elbow_trans">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
      <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
    <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
"""
_CONTROLLERS = """
    states: {type: joint_state_controller/JointStateController, publish_rate: 50}
    arm:
      type: position_controllers/JointGroupPositionController
      joints: [%s]
"""


@rule(
    "UC462",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: joints are those of the transmissions; "
    "ros_control: \"Could not find resource 'shoulder' in 'hardware_interface::PositionJointInterface'.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«shoulder», elbow"},
    good={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow"},
)
def joint_without_transmission(project: Project) -> Iterator[Finding]:
    """A controller commands a joint that has no transmission.

    In Gazebo a joint can be commanded, and its state be read, when a <transmission> of the robot names it. A joint of
    the URDF alone swings freely, and the controller that asks for it is not loaded.
    """
    return of_each_candidate(project, lambda session, one: _undriven(project, session, one))


def _undriven(project: Project, session: Session, one: Configured) -> Iterator[Finding]:
    found = [each for each in unregistered(session, one) if not session.hardware.has(each.claim.component)]
    severity = mended_severity(project, session, one) if found else None
    if severity is None or (severity is Severity.WARNING and not session.hardware.command):
        return
    named = _named_in_transmissions(project)
    for each in found:
        joint, at = each.claim.component, place_of(one, each.claim)
        if joint in named or at is None:
            continue
        kind = next((j.type for j in (project.robot.joints if project.robot else ()) if j.name == joint), None)
        if kind == "fixed":
            message = f"controller '{one.name}' wants to move '{joint}', which is fixed: no transmission can drive it"
        else:
            message = (
                f"'{joint}' has no <transmission>, so that controller '{one.name}' does not find it in the "
                f"{bare(each.claim.interface)}"
            )
        others = in_words(session.hardware.command)
        notes = (Note(f"transmissions drive {others}"),) if others else ()
        yield Finding(at, message, notes, severity=severity)


def _named_in_transmissions(project: Project) -> set[str | None]:
    """The joints of all transmissions, those that are not read too: other rules say why."""
    robot = project.robot
    every = (*robot.transmissions, *robot.nested_transmissions) if robot else ()
    named = {joint.name for transmission in every for joint in transmission.joints}
    inside = (one for control in (robot.ros2_controls if robot else ()) for one in control.transmissions)
    return named | {joint.name for transmission in inside for joint in transmission.joints}
