"""UC453."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.chains import chained_claims
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import home, of_each_candidate, place_of

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        low: {type: forward_command_controller/ForwardCommandController}
        high: {type: forward_command_controller/ForwardCommandController}
    low:
      ros__parameters:
        joints: [elbow]
        interface_name: position
    high:
      ros__parameters:
        joints: [%s]
        interface_name: position
"""


@rule(
    "UC453",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("humble"),
    authority='ros2_control controller_manager/src/controller_manager.cpp: "No state/reference interface from '
    "controller : 'low/elbow/position' exist, since the following controller with name 'low' is not chainable.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«low/elbow»"}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow"}],
)
def chained_controller_exports_nothing(project: Project) -> Iterator[Finding]:
    """Claim of an interface of a controller that exports none.

    Only chainable types, such as pid_controller, export interfaces for other controllers. The name before the first
    slash is looked up among the controllers first, then in the hardware: a controller with a joint's name hides the
    joint. The claiming controller cannot be activated.
    """
    return of_each_candidate(project, _unchainable)


def _unchainable(session: Session, controller: Configured) -> Iterator[Finding]:
    for chained in chained_claims(session, controller):
        following, at = chained.following, place_of(controller, chained.claim)
        exports = following.exports
        if chained.is_offered is not False or at is None or exports.reference or exports.state:
            continue
        name, kind = following.name, following.type.type if following.type else ""
        if session.hardware.has(name):
            message = (
                f"controller '{name}' has the same name as '{name}' in the hardware, and hides "
                f"'{chained.claim.name}'; rename the controller"
            )
        else:
            message = (
                f"controller '{controller.name}' claims '{chained.claim.name}', "
                f"but controller '{name}' exports nothing: type '{kind}' is not chainable"
            )
        declared = home(following.controller)
        yield Finding(at, message, (Note(f"controller '{name}' is declared here", declared),) if declared else ())
