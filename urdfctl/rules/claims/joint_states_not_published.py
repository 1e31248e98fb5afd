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
    runtime="misbehaves",
    because="another node may publish them",
    authority="robot_state_publisher subscribes to joint_states, which joint_state_broadcaster (ROS 1: "
    "joint_state_controller) publishes",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % ("«controller_manager»", "# no more")}],
    good=[
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": _CONTROLLERS
            % ("controller_manager", "states: {type: joint_state_broadcaster/JointStateBroadcaster}"),
        },
    ],
)
def joint_states_not_published(project: Project) -> Iterator[Finding]:
    """Joint states are not published.

    Controllers move joints, but only joint_state_broadcaster (in ROS 1 joint_state_controller) publishes their
    positions. Without it there are no transforms: RViz shows all links in one place, and MoveIt waits for the robot's
    state. It may be in another file, or another node may publish the joint states: a joint_state_publisher with a
    source_list is accepted.
    """
    sessions = seen(project)
    if not sessions or not all(map(_is_silent, sessions)) or _is_published_elsewhere(project):
        return
    session = sessions[-1]
    started = session.started is not None
    launch = project.launch
    spawned = next((at for spawn in launch.spawns for _, at in spawn.names), None) if launch else None
    at = spawned if started and spawned else _place(session)
    idle = next((controller for controller in session.controllers if _publishes(controller)), None)
    if at is None:
        return
    severity = Severity.WARNING if started and project.launch is not None else Severity.INFO
    if idle is not None:
        message = f"controller '{idle.name}', which publishes the joint states, is not started; spawn it too"
        yield Finding(at, message, severity=severity)
    else:
        kinds = (
            project.catalog.controller(name, session.distro) for name in project.catalog.known_types(session.distro)
        )
        known = next((kind.type for kind in kinds if kind and kind.publishes_joint_states), "")
        state = "started" if started else "declared"
        message = f"no {state} controller publishes the joint states; add one of type '{known}'"
        yield Finding(at, message, severity=severity)


def _is_silent(session: Session) -> bool:
    """Whether the candidates are known, some of them move joints, and none publishes the joint states."""
    candidates = session.candidates
    if any(controller.type is None or _publishes(controller) for controller in candidates):
        return False
    return any(controller.claims.command for controller in candidates)


def _publishes(controller: Configured) -> bool:
    return controller.type is not None and controller.type.publishes_joint_states


def _is_published_elsewhere(project: Project) -> bool:
    """Whether a plugin publishes them, or a joint_state_publisher that gets them from a list of topics."""
    nodes = project.launch.nodes if project.launch else ()
    if any("joint_state_publisher" in node.executable.text and _SOURCES in node.at.source.data for node in nodes):
        return True
    names = [f"{plugin.filename} {plugin.name}" for plugin in (project.robot.plugins if project.robot else ())]
    return any("jointstate" in name.lower().replace("_", "") for name in names)


def _place(session: Session) -> Place | None:
    first = next(controller for controller in session.candidates if controller.claims.command)
    manager = first.controller.manager
    return home(first.controller) if session.started is not None or manager is None else manager.at


_SOURCES = b"source_list"
