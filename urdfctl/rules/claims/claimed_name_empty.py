"""UC477."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.claims.common import of_each_candidate

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
        arm: {type: forward_command_controller/ForwardCommandController}
    arm:
      ros__parameters:
        joints: [%s]
        interface_name: position
"""


@rule(
    "UC477",
    stage=Stage.ACTIVATE,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control controller_manager.cpp: \"Unable to activate controller 'arm' since the command interface "
    "'/position' is not available.\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow, «''»"}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow"}],
)
def claimed_name_empty(project: Project) -> Iterator[Finding]:
    """Controller claims an interface of a joint without name.

    An empty text among the joints makes the controller claim '/position'. No hardware has that, so the controller is
    not activated.
    """
    return of_each_candidate(project, _empty)


def _empty(session: Session, controller: Configured) -> Iterator[Finding]:
    del session
    claimed = controller.type.claims if controller.type else None
    for each in (*claimed.command, *claimed.state) if claimed else ():
        given = (
            controller.controller.parameters.value(each.for_each) if each.for_each and not each.best_effort else None
        )
        empty = next((item for item in given.items if item.value == ""), None) if given else None
        if empty is not None:
            message = f"'{each.for_each}' of controller '{controller.name}' has an empty name"
            yield Finding(empty.at, message)
            return
