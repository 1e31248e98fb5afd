"""UC454."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.chains import circle, late
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import of_each_candidate, place_of

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="elbow"><command_interface name="effort"/><state_interface name="position"/></joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        %s
        arm: {type: forward_command_controller/ForwardCommandController}
    pid:
      ros__parameters:
        dof_names: [elbow]
        command_interface: effort
        reference_and_state_interfaces: [position]
        gains: {elbow: {p: 5.0}}
    low:
      ros__parameters:
        dof_names: [elbow]
        command_interface: effort
        reference_and_state_interfaces: [position]
        gains: {elbow: {p: 5.0}}
    arm:
      ros__parameters:
        joints: [%s]
        interface_name: position
"""
_BOTH = """pid: {type: pid_controller/PidController}
        low: {type: pid_controller/PidController}"""


@rule(
    "UC454",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("humble"),
    authority="ros2_control controller_manager/src/controller_manager.cpp: \"The following controller with name 'pid' is "
    'currently inactive and it is not requested to be activated."',
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy", "--start=states,low,arm"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % (_BOTH, "«pid/elbow»")}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % (_BOTH, "low/elbow")}],
)
def chained_controller_not_started(project: Project) -> Iterator[Finding]:
    """Chained controller is not started first.

    A controller cannot be activated unless the controllers whose reference interfaces it claims are active, or are
    activated in the same request. The spawner activates its controllers one by one, in the given order, unless it has
    the option `--activate-as-group`.
    """
    return of_each_candidate(project, _late)


def _late(session: Session, controller: Configured) -> Iterator[Finding]:
    if session.started is None or circle(session, controller):
        return
    reported = set()
    for chained in late(session, controller):
        name, at = chained.following.name, place_of(controller, chained.claim)
        if not chained.is_offered or at is None or name in reported:
            continue
        reported.add(name)
        if chained.following in session.started:
            message = (
                f"controller '{controller.name}' claims '{chained.claim.name}', but is started before '{name}'; "
                f"start '{name}' first, or both at once with --activate-as-group"
            )
        else:
            message = (
                f"controller '{controller.name}' claims '{chained.claim.name}', but '{name}' is not started; "
                f"start '{name}' first"
            )
        yield Finding(at, message)
