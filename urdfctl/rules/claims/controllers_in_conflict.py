"""UC456."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.conflicts import Conflict, conflicts, resource
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import home, of_each_candidate, place_of, seen
from urdfctl.rules.common import in_words

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        arm: {type: forward_command_controller/ForwardCommandController}
        hand: {type: forward_command_controller/ForwardCommandController}
    arm:
      ros__parameters:
        joints: [%s]
        interface_name: position
    hand:
      ros__parameters:
        joints: [%s]
        interface_name: position
"""


@rule(
    "UC456",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager/src/controller_manager.cpp: \"Resource conflict for controller 'hand'. "
    "Command interface 'elbow/position' is already claimed.\"; ros_control hardware_interface/robot_hw.h, "
    "checkForConflict: 'Resource conflict on [elbow].  Controllers = [arm, hand]'",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy", "--start=states,arm,hand"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % ("shoulder, elbow", "«elbow»")}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % ("shoulder", "elbow")}],
)
def controllers_in_conflict(project: Project) -> Iterator[Finding]:
    """Controllers that are started together claim the same interface.

    In ROS 2 a command interface belongs to one active controller, so the second controller is refused. In ROS 1 a whole
    joint belongs to one controller, whatever the interface. There a spawner starts all its controllers in one request,
    so none of them starts. Declaring both controllers in a file is harmless: they may take turns.
    """
    by_second: dict[int, list[Conflict]] = {}
    for session in seen(project):
        for conflict in conflicts(session):
            by_second.setdefault(id(conflict.second), []).append(conflict)
    return of_each_candidate(
        project, lambda session, controller: _refused(session, controller, by_second.get(id(controller), []))
    )


def _refused(session: Session, controller: Configured, with_others: list[Conflict]) -> Iterator[Finding]:
    by_first: dict[str, list[Conflict]] = {}
    for conflict in with_others:
        by_first.setdefault(conflict.first.name, []).append(conflict)
    for name, conflicts_with_first in by_first.items():
        first, is_only = conflicts_with_first[0], len(conflicts_with_first) == 1
        at = place_of(controller, first.claim) if is_only else home(controller.controller)
        if at is None:
            continue
        kind = "joint" if generation(session.distro) == 1 else "command interface"
        claimed = in_words([resource(each.claim, session.distro) for each in conflicts_with_first])
        plural = "" if is_only else "s"
        earlier = place_of(first.first, first.earlier)
        notes = (Note(f"controller '{name}' claims '{resource(first.claim, session.distro)}' here", earlier),)
        both = f"controllers '{name}' and '{controller.name}'"
        message = f"{both} are started together, but both claim {kind}{plural} {claimed}"
        yield Finding(at, message, notes if earlier else ())
