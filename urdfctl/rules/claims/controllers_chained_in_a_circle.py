"""UC455."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.chains import circle
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import home, of_each_candidate

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
        outer: {type: %s}
        inner: {type: %s}
    outer:
      ros__parameters:
        dof_names: [inner/elbow]
        reference_and_state_dof_names: [elbow]
        command_interface: velocity
        reference_and_state_interfaces: [position]
        gains: {inner/elbow: {p: 5.0}}
    inner:
      ros__parameters:
        dof_names: [%s]
        reference_and_state_dof_names: [elbow]
        command_interface: %s
        reference_and_state_interfaces: [velocity]
        gains: {%s: {p: 5.0}}
"""
_PID = "pid_controller/PidController"


@rule(
    "UC455",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("humble"),
    authority="ros2_control controller_manager/src/controller_manager.cpp, check_following_controllers_for_activate: "
    "each controller waits for the next to be active",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": _CONTROLLERS % (f"«{_PID}»", _PID, "outer/elbow", "position", "outer/elbow"),
        },
    ],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % (_PID, _PID, "elbow", "effort", "elbow")}],
)
def controllers_chained_in_a_circle(project: Project) -> Iterator[Finding]:
    """Controllers are chained in a loop.

    Each controller can be activated only after the next one, so none can be activated. A chain must end with a
    controller that claims interfaces of the hardware.
    """
    return of_each_candidate(project, _loop)


def _loop(session: Session, controller: Configured) -> Iterator[Finding]:
    loop = circle(session, controller)
    at = home(controller.controller)
    first = min(loop, key=session.controllers.index, default=None)
    if at is None or first is not controller or len(loop) == 1:
        return
    names = " -> ".join(f"'{each.name}'" for each in (*loop, controller))
    notes = [Note(f"controller '{each.name}' is declared here", home(each.controller)) for each in loop[1:]]
    message = f"controllers claim each other's interfaces in a loop, so none can be activated: {names}"
    yield Finding(at, message, tuple(notes))
