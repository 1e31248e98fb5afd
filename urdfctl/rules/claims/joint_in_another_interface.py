"""UC461."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware import Kind
from urdfctl.control.session import Configured, Missing, Session
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.claims.common import home, of_each_candidate, place_of
from urdfctl.rules.claims.ros1 import bare, mended_severity, unregistered
from urdfctl.rules.common import in_words, replaced

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
      type: %s
      joint: elbow
"""


@rule(
    "UC461",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="ros_control hardware_interface/internal/resource_manager.h: \"Could not find resource 'elbow' in "
    "'hardware_interface::EffortJointInterface'.\"; ros_controllers joint_trajectory_controller: \"Could not find joint "
    "'elbow' in 'hardware_interface::EffortJointInterface'.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«effort_controllers/JointEffortController»"},
    good={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "position_controllers/JointPositionController"},
)
def joint_in_another_interface(project: Project) -> Iterator[Finding]:
    """A controller wants a joint in another hardware interface than its transmission offers it in.

    The first part of a controller's type says what it writes to the joint: effort_controllers write torques and look
    for the joint in the EffortJointInterface. Gazebo puts a joint into the interface that its transmission names, and
    into no other; so the controller does not find it and is not loaded. Either the type or the transmission is wrong.
    """
    return of_each_candidate(project, lambda session, one: _elsewhere(project, session, one))


def _elsewhere(project: Project, session: Session, one: Configured) -> Iterator[Finding]:
    found = [each for each in unregistered(session, one) if session.hardware.of(Kind.COMMAND, each.claim.component)]
    severity = mended_severity(project, session, one) if found else None
    if severity is None:
        return
    joints = {claim.component for claim in one.claims.command}
    offered = {_offered(session, each) for each in found}
    if len(found) == len(joints) and len(offered) == 1:
        yield from _finding(project, session, one, found, severity)
    else:
        for each in found:
            yield from _finding(project, session, one, [each], severity)


def _offered(session: Session, missing: Missing) -> str:
    return session.hardware.of(Kind.COMMAND, missing.claim.component)[0].interface


def _finding(
    project: Project, session: Session, one: Configured, found: list[Missing], severity: Severity
) -> Iterator[Finding]:
    claim, offered = found[0].claim, _offered(session, found[0])
    whole = len(found) == len({each.component for each in one.claims.command})
    at = home(one.controller) if whole else place_of(one, claim)
    if at is None or one.type is None:
        return
    joints = in_words([each.claim.component for each in found])
    other = _of_interface(project, one, offered) if whole else None
    transmissions = "the transmission" if len(found) == 1 else "the transmissions"
    mend = f"name '{claim.interface}' in {transmissions}"
    mends = f"use '{other}', or {mend}" if other else mend
    message = (
        f"controller '{one.name}' wants {joints} in the {bare(claim.interface)}, and {transmissions} "
        f"offer{'s' * (len(found) == 1)} the {bare(offered)}: {mends}"
    )
    here = session.hardware.of(Kind.COMMAND, claim.component)[0].at
    notes = (Note(f"the transmission of '{claim.component}' names its interface here", here.content),)
    fix = replaced(at, one.type.type, other) if other else Fix(mend)
    yield Finding(at, message, notes, fix, severity)


def _of_interface(project: Project, one: Configured, interface: str) -> str | None:
    """The type that does the same with another interface: of the same name in another package."""
    kind = one.type
    if kind is None:
        return None
    for name in project.catalog.known_types(kind.distro):
        if name.partition("/")[2] == kind.type.partition("/")[2] and name != kind.type:
            other = project.catalog.controller(name, kind.distro)
            if other is not None and other.hardware_interfaces == (interface,):
                return name
    return None
