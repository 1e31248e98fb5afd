"""UC455."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.chains import circle
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, rule
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
    severity=Severity.ERROR,
    distros=since("humble"),
    authority="ros2_control controller_manager/src/controller_manager.cpp, check_following_controllers_for_activate: "
    "each controller waits for the next to be active",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": _ROBOT,
        "controllers.yaml": _CONTROLLERS % (f"«{_PID}»", _PID, "outer/elbow", "position", "outer/elbow"),
    },
    good={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % (_PID, _PID, "elbow", "effort", "elbow")},
)
def controllers_chained_in_a_circle(project: Project) -> Iterator[Finding]:
    """Controllers claim each other's interfaces in a circle.

    Each of them can be activated only when the next one is, so none ever is. A chain has an end: a controller that
    claims the interfaces of hardware.
    """
    return of_each_candidate(project, _round)


def _round(session: Session, one: Configured) -> Iterator[Finding]:
    way = circle(session, one)
    at = home(one.controller)
    first = min(way, key=session.controllers.index, default=None)
    if at is None or first is not one or len(way) == 1:
        return
    names = " -> ".join(f"'{each.name}'" for each in (*way, one))
    notes = [Note(f"controller '{each.name}' is declared here", home(each.controller)) for each in way[1:]]
    yield Finding(at, f"controllers claim each other's interfaces, so none can be activated: {names}", tuple(notes))
