"""UC458."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.inactive_hardware import inactive_hardware
from urdfctl.control.session import Configured, Session
from urdfctl.model.controllers import Value
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import home, of_each_candidate

_ROBOT = """
    <ros2_control name="arm_hardware" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        hardware_components_initial_state:
          %s: [%s]
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        arm: {type: forward_command_controller/ForwardCommandController}
    states:
      ros__parameters:
        frame_id: base
    arm:
      ros__parameters:
        joints: [shoulder, elbow]
        interface_name: position
"""


@rule(
    "UC458",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("humble"),
    authority="ros2_control controller_manager/src/controller_manager.cpp, init_resource_manager and, from jazzy 4.38.0 "
    "on, 'Could not switch controllers since prepare command mode switch was rejected.'",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy", "--start=states,arm"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % ("unconfigured", "«arm_hardware»")}],
    good=[
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    hardware_components_initial_state: {unconfigured: [arm_hardware]}
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """,
            "options": "--start=states",
        },
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
            """,
        },
    ],
)
def hardware_not_active(project: Project) -> Iterator[Finding]:
    """Controller of hardware that is not activated.

    The controller manager is configured to leave the hardware inactive or unconfigured. Unconfigured hardware has no
    interfaces to claim. Inactive hardware has them, but from jazzy on controllers that command it are refused too,
    unless the manager is configured to allow them. Activate the hardware first, for example with hardware_spawner.
    """
    if _is_activated(project):
        return
    reported: set[int] = set()
    for finding in of_each_candidate(project, _inactive):
        if id(finding.at) not in reported:
            reported.add(id(finding.at))
            yield finding


def _is_activated(project: Project) -> bool:
    nodes = project.launch.nodes if project.launch else ()
    return any(node.runs("controller_manager", "hardware_spawner") for node in nodes)


def _inactive(session: Session, controller: Configured) -> Iterator[Finding]:
    for hardware, state, named in inactive_hardware(session, controller):
        yield _finding(controller, named, hardware, state)


def _finding(controller: Configured, named: Value, hardware: str, state: str) -> Finding:
    declared = home(controller.controller)
    notes = (Note(f"controller '{controller.name}' is declared here", declared),) if declared else ()
    message = f"hardware '{hardware}' stays {state}, so controller '{controller.name}' cannot be activated"
    return Finding(named.at, message, notes)
