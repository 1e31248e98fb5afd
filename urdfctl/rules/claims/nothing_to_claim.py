"""UC472."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control import needed_interfaces
from urdfctl.control.hardware.interfaces import Absence
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import home, of_each_candidate

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/>%s</joint>
      <joint name="elbow"><command_interface name="position"/>%s</joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: %s}
        arm: {type: forward_command_controller/ForwardCommandController}
    arm:
      ros__parameters:
        joints: [shoulder, elbow]
        interface_name: position
"""
_TYPE = "joint_state_broadcaster/JointStateBroadcaster"
_STATE = '<state_interface name="position"/>'


@rule(
    "UC472",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=since("galactic"),
    authority="ros2_controllers joint_state_broadcaster.cpp, init_joint_data: 'No state interfaces found to publish.' "
    "(before jazzy 'None of requested interfaces exist. Controller will not run.'); gpio_command_controller.cpp, "
    "on_configure: 'No command or state interfaces are configured'",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT % ("", ""), "controllers.yaml": _CONTROLLERS % f"«{_TYPE}»"}],
    good=[{"robot.urdf": _ROBOT % (_STATE, _STATE), "controllers.yaml": _CONTROLLERS % _TYPE}],
)
def nothing_to_claim(project: Project) -> Iterator[Finding]:
    """Controller has no interface to claim.

    joint_state_broadcaster publishes the state interfaces of the hardware, and gpio_controllers those of its gpios.
    If there are none, the controller is refused. Add a <state_interface> to each joint or gpio in <ros2_control>.
    """
    return of_each_candidate(project, _idle)


def _idle(session: Session, controller: Configured) -> Iterator[Finding]:
    absence = needed_interfaces.nothing_to_claim(session, controller)
    at = home(controller.controller)
    if absence is None or controller.type is None or at is None:
        return
    sure = absence is Absence.SURE
    wanted = "state interface" if controller.type.broadcaster else "interface of its gpios"
    message = f"controller '{controller.name}' has nothing to claim: the hardware exports no {wanted}"
    notes = () if sure else (Note("the driver may export more interfaces than the description lists"),)
    yield Finding(at, message, notes, severity=Severity.ERROR if sure else Severity.WARNING)
