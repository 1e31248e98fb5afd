"""UC456."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.conflicts import Conflict, conflicts, resource
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, rule
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
    severity=Severity.ERROR,
    authority="ros2_control controller_manager/src/controller_manager.cpp: \"Resource conflict for controller 'hand'. "
    "Command interface 'elbow/position' is already claimed.\"; ros_control hardware_interface/robot_hw.h, "
    "checkForConflict: 'Resource conflict on [elbow].  Controllers = [arm, hand]'",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy", "--start=states,arm,hand"],
    bad={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % ("shoulder, elbow", "«elbow»")},
    good={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % ("shoulder", "elbow")},
)
def controllers_in_conflict(project: Project) -> Iterator[Finding]:
    """Two controllers that are started together claim the same.

    In ROS 2 a command interface belongs to one active controller, so the second one is refused. In ROS 1 a whole joint
    does, whatever the interface; and as a spawner starts all its controllers in one request, none of them starts. That a
    file declares both does no harm: they may take turns.
    """
    by_second: dict[int, list[Conflict]] = {}
    for session in seen(project):
        for conflict in conflicts(session):
            by_second.setdefault(id(conflict.second), []).append(conflict)
    return of_each_candidate(project, lambda session, one: _refused(session, one, by_second.get(id(one), [])))


def _refused(session: Session, one: Configured, with_others: list[Conflict]) -> Iterator[Finding]:
    by_first: dict[str, list[Conflict]] = {}
    for conflict in with_others:
        by_first.setdefault(conflict.first.name, []).append(conflict)
    for name, found in by_first.items():
        first = found[0]
        at = place_of(one, first.claim) if len(found) == 1 else home(one.controller)
        if at is None:
            continue
        what = "joint" if generation(session.distro) == 1 else "command interface"
        claimed = in_words([resource(each.claim, session.distro) for each in found])
        plural = "s" if len(found) > 1 else ""
        earlier = place_of(first.first, first.earlier)
        notes = (Note(f"controller '{name}' claims '{resource(first.claim, session.distro)}' here", earlier),)
        message = (
            f"controllers '{name}' and '{one.name}' are started together and both claim the {what}{plural} {claimed}"
        )
        yield Finding(at, message, notes if earlier else ())
