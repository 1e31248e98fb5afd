"""UC452."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.chains import Chained, chained_claims
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import Configured, Session
from urdfctl.names import nearest
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import home, of_each_candidate, place_of

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="elbow">
        <command_interface name="effort"/>
        <state_interface name="position"/>
        <state_interface name="velocity"/>
      </joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        pid: {type: pid_controller/PidController}
        arm: {type: forward_command_controller/ForwardCommandController}
    pid:
      ros__parameters:
        dof_names: [elbow]
        command_interface: effort
        reference_and_state_interfaces: [position]
        gains: {elbow: {p: 5.0}}
    arm:
      ros__parameters:
        joints: [%s]
        interface_name: %s
"""


@rule(
    "UC452",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("humble"),
    authority="ros2_control controller_manager/src/controller_manager.cpp: \"Unable to activate controller 'arm' since "
    "the command interface 'pid/elbow/velocity' is not available.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % ("«pid/elbow»", "velocity")}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % ("pid/elbow", "position")}],
)
def chained_interface_not_exported(project: Project) -> Iterator[Finding]:
    """Claimed interface is not exported by the other controller.

    A name that starts with a controller's name is looked up in that controller's exports: its reference interfaces for
    commands, and from jazzy on its state interfaces. Both depend on its parameters. The claiming controller cannot be
    activated.
    """
    return of_each_candidate(project, _unexported)


def _unexported(session: Session, controller: Configured) -> Iterator[Finding]:
    for chained in chained_claims(session, controller):
        exports = chained.following.exports
        offered = exports.reference if chained.kind is ClaimKind.COMMAND else exports.state
        at = place_of(controller, chained.claim)
        if chained.is_offered is False and at is not None and (exports.reference or exports.state):
            yield Finding(at, _message(chained, [claim.name for claim in offered]), _notes(chained))


def _message(chained: Chained, offered: list[str]) -> str:
    kind = "reference interface" if chained.kind is ClaimKind.COMMAND else "state interface"
    following, preceding = chained.following.name, chained.preceding.name
    message = f"controller '{following}' has no {kind} '{chained.claim.name}', which controller '{preceding}' claims"
    if not offered:
        return f"{message}; it exports no {kind}s"
    right = nearest(chained.claim.name, offered)
    return message + (f"; did you mean '{right}'?" if right else f"; it exports: {', '.join(offered)}")


def _notes(chained: Chained) -> tuple[Note, ...]:
    at = home(chained.following.controller)
    return (Note(f"controller '{chained.following.name}' is declared here", at),) if at else ()
