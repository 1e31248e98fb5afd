"""UC462."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
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
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="gazebo_ros_pkgs gazebo_ros_control/src/default_robot_hw_sim.cpp: joints are those of the transmissions; "
    "ros_control: \"Could not find resource 'shoulder' in 'hardware_interface::PositionJointInterface'.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«shoulder», elbow"}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow"}],
)
def joint_without_transmission(project: Project) -> Iterator[Finding]:
    """Controller uses a joint without a transmission.

    Gazebo can command a joint, or read its state, only if a <transmission> of the robot names it. Without one the joint
    swings freely, and a controller that uses it is not loaded.
    """
    return of_each_candidate(project, lambda session, controller: _undriven(project, session, controller))


def _undriven(project: Project, session: Session, controller: Configured) -> Iterator[Finding]:
    missing = [each for each in unregistered(session, controller) if not session.hardware.has(each.claim.component)]
    severity = mended_severity(project, session, controller) if missing else None
    if severity is None or (severity is Severity.WARNING and not session.hardware.command):
        return
    named = _named_in_transmissions(project)
    for each in missing:
        joint, at = each.claim.component, place_of(controller, each.claim)
        if joint in named or at is None:
            continue
        kind = next((j.type for j in (project.robot.joints if project.robot else ()) if j.name == joint), None)
        if kind == "fixed":
            message = (
                f"controller '{controller.name}' uses joint '{joint}', which is fixed; no transmission can drive it"
            )
        else:
            message = (
                f"joint '{joint}' has no <transmission>; controller '{controller.name}' does not find it in the "
                f"{bare(each.claim.interface)}"
            )
        others = in_words(session.hardware.command)
        notes = (Note(f"joints with a transmission: {others}"),) if others else ()
        yield Finding(at, message, notes, severity=severity)


def _named_in_transmissions(project: Project) -> set[str | None]:
    """The joints of all transmissions, including ignored ones, which other rules report."""
    robot = project.robot
    transmissions = (*robot.transmissions, *robot.nested_transmissions) if robot else ()
    named = {joint.name for transmission in transmissions for joint in transmission.joints}
    controls = robot.ros2_controls if robot else ()
    inside = (transmission for control in controls for transmission in control.transmissions)
    return named | {joint.name for transmission in inside for joint in transmission.joints}
