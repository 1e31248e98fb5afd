"""UC465."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.claims.common import home, seen
from urdfctl.source.span import Place

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""
_CONTROLLERS = """
    %s:
      ros__parameters:
        update_rate: 100
        arm: {type: forward_command_controller/ForwardCommandController}
        %s
    arm:
      ros__parameters:
        joints: [shoulder, elbow]
        interface_name: position
"""


@rule(
    "UC465",
    severity=Severity.INFO,
    authority="robot_state_publisher subscribes to joint_states, which joint_state_broadcaster (ROS 1: "
    "joint_state_controller) publishes",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % ("«controller_manager»", "# no more")},
    good={
        "robot.urdf": _ROBOT,
        "controllers.yaml": _CONTROLLERS
        % ("controller_manager", "states: {type: joint_state_broadcaster/JointStateBroadcaster}"),
    },
)
def joint_states_not_published(project: Project) -> Iterator[Finding]:
    """No controller publishes the states of the joints.

    Controllers move joints, and tell nobody where they are: that is what joint_state_broadcaster is for, in ROS 1
    joint_state_controller. Without it there are no transforms, so that RViz shows the links in a heap, and MoveIt waits
    for the robot's state. It may stand in another file, or another node may publish the joint states.
    """
    sessions = seen(project)
    if not sessions or not all(map(_is_silent, sessions)) or _is_published_by_plugin(project):
        return
    session = sessions[-1]
    started = session.started is not None
    at = _place(session)
    idle = next((one for one in session.controllers if _publishes(one)), None)
    if at is None:
        return
    severity = Severity.WARNING if started and project.launch is not None else Severity.INFO
    if idle is not None:
        yield Finding(at, f"'{idle.name}', which publishes the joint states, is not started", severity=severity)
    else:
        kinds = (
            project.catalog.controller(name, session.distro) for name in project.catalog.known_types(session.distro)
        )
        known = next((kind.type for kind in kinds if kind and kind.publishes_joint_states), "")
        which = "that is started" if started else "that is declared"
        message = f"no controller {which} publishes the joint states: add one of type '{known}'"
        yield Finding(at, message, severity=severity)


def _is_silent(session: Session) -> bool:
    """Whether controllers that move joints are known, and none of those that may run publishes their states."""
    candidates = session.candidates
    if not all(one.type is not None for one in candidates) or any(_publishes(one) for one in candidates):
        return False
    return any(one.claims.command for one in candidates)


def _publishes(one: Configured) -> bool:
    return one.type is not None and one.type.publishes_joint_states


def _is_published_by_plugin(project: Project) -> bool:
    names = [f"{plugin.filename} {plugin.name}" for plugin in (project.robot.plugins if project.robot else ())]
    return any("jointstate" in name.lower().replace("_", "") for name in names)


def _place(session: Session) -> Place | None:
    first = next(one for one in session.candidates if one.claims.command)
    manager = first.controller.manager
    return home(first.controller) if session.started is not None or manager is None else manager.at
