"""UC454."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.chains import circle, late
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Project, Severity, rule
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
    severity=Severity.ERROR,
    distros=since("humble"),
    authority="ros2_control controller_manager/src/controller_manager.cpp: \"The following controller with name 'pid' is "
    'currently inactive and it is not requested to be activated."',
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy", "--start=states,low,arm"],
    bad={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % (_BOTH, "«pid/elbow»")},
    good={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % (_BOTH, "low/elbow")},
)
def chained_controller_not_started(project: Project) -> Iterator[Finding]:
    """A controller is started that claims the interface of another one, which is not started before it.

    A controller can be activated when those whose reference interfaces it claims are active, or become so in the same
    request. The spawner activates the controllers that it is given one by one, in their order, unless it is told
    `--activate-as-group`.
    """
    return of_each_candidate(project, _late)


def _late(session: Session, one: Configured) -> Iterator[Finding]:
    if session.started is None or circle(session, one):
        return
    told = set()
    for chained in late(session, one):
        name, at = chained.following.name, place_of(one, chained.claim)
        if not chained.is_offered or at is None or name in told:
            continue
        told.add(name)
        if chained.following in session.started:
            message = (
                f"controller '{one.name}' is started before '{name}', whose interface '{chained.claim.name}' it claims: "
                f"start '{name}' first, or both at once with --activate-as-group"
            )
        else:
            message = (
                f"controller '{one.name}' claims '{chained.claim.name}', and '{name}', which exports it, is not started: "
                f"start '{name}' before it"
            )
        yield Finding(at, message)
