"""UC461."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import Configured, MissingInterface, Session
from urdfctl.rule import Edit, Finding, Fix, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import home, of_each_candidate, place_of
from urdfctl.rules.claims.ros1 import bare, mended_severity, unregistered
from urdfctl.rules.common import in_words, replaced
from urdfctl.source.span import Place

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
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="ros_control hardware_interface/internal/resource_manager.h: \"Could not find resource 'elbow' in "
    "'hardware_interface::EffortJointInterface'.\"; ros_controllers joint_trajectory_controller: \"Could not find joint "
    "'elbow' in 'hardware_interface::EffortJointInterface'.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«effort_controllers/JointEffortController»"}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "position_controllers/JointPositionController"}],
)
def joint_in_another_interface(project: Project) -> Iterator[Finding]:
    """Controller and transmission use different hardware interfaces.

    The first part of a controller's type says what it writes to the joint: effort_controllers write torques, and expect
    the joint in the EffortJointInterface. Gazebo registers a joint only with the interface that its transmission names.
    The controller does not find the joint there, and is not loaded. Either the type or the transmission is wrong.
    """
    return of_each_candidate(project, lambda session, controller: _mismatched(project, session, controller))


def _mismatched(project: Project, session: Session, controller: Configured) -> Iterator[Finding]:
    hardware = session.hardware
    missing = [
        each for each in unregistered(session, controller) if hardware.of(ClaimKind.COMMAND, each.claim.component)
    ]
    severity = mended_severity(project, session, controller) if missing else None
    if severity is None:
        return
    joints = {claim.component for claim in controller.claims.command}
    offered = {_offered(session, each) for each in missing}
    if len(missing) == len(joints) and len(offered) == 1:
        yield from _finding(project, session, controller, missing, severity)
    else:
        for each in missing:
            yield from _finding(project, session, controller, [each], severity)


def _offered(session: Session, missing: MissingInterface) -> str:
    return session.hardware.of(ClaimKind.COMMAND, missing.claim.component)[0].interface


def _finding(
    project: Project, session: Session, controller: Configured, missing: list[MissingInterface], severity: Severity
) -> Iterator[Finding]:
    claim, offered = missing[0].claim, _offered(session, missing[0])
    is_whole = len(missing) == len({each.component for each in controller.claims.command})
    at = home(controller.controller) if is_whole else place_of(controller, claim)
    if at is None or controller.type is None:
        return
    joints = in_words([each.claim.component for each in missing])
    other = _of_interface(project, controller, offered) if is_whole else None
    transmissions = "the transmission" if len(missing) == 1 else "the transmissions"
    change = f"name '{claim.interface}' in {transmissions}"
    advice = f"use '{other}', or {change}" if other else change
    message = (
        f"controller '{controller.name}' requires {joints} in the {bare(claim.interface)}, but {transmissions} "
        f"offer{'s' * (len(missing) == 1)} the {bare(offered)}; {advice}"
    )
    interface_at = session.hardware.of(ClaimKind.COMMAND, claim.component)[0].at
    notes = (Note(f"the transmission of '{claim.component}' names its interface here", interface_at.content),)
    places = [session.hardware.of(ClaimKind.COMMAND, each.claim.component)[0].at.content for each in missing]
    fix = replaced(at, controller.type.type, other) if other else Fix(change, _renamed(places, claim.interface))
    yield Finding(at, message, notes, fix, severity)


def _renamed(places: list[Place], interface: str) -> tuple[Edit, ...]:
    """The edits that write an interface into transmissions, with the prefix where they have one."""
    edits = []
    for place in places:
        text = place.span.text
        if re.fullmatch(r"(hardware_interface/)?\w+Interface", text) is None:
            return ()
        edits.append(Edit(place.span, interface if "/" in text else bare(interface)))
    return tuple(dict.fromkeys(edits))


def _of_interface(project: Project, controller: Configured, interface: str) -> str | None:
    """The type with the same class name in another package, which uses the given interface."""
    kind = controller.type
    if kind is None:
        return None
    for name in project.catalog.known_types(kind.distro):
        if name.partition("/")[2] == kind.type.partition("/")[2] and name != kind.type:
            other = project.catalog.controller(name, kind.distro)
            if other is not None and other.hardware_interfaces == (interface,):
                return name
    return None
