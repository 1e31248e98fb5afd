"""UC450."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.rule import Finding, Project, Severity, StageDependsOn, rule
from urdfctl.rules.claims.common import of_each_candidate
from urdfctl.rules.claims.unoffered import unoffered

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""


@rule(
    "UC450",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control controller_manager/src/controller_manager.cpp: \"Unable to activate controller 'arm' since "
    "the command interface 'shoulder/effort' is not available.\", before jazzy: \"Command interface with "
    "'shoulder/effort' does not exist\"",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": _ROBOT,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: «effort»
            """,
        },
    ],
    good=[
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
def command_interface_not_exported(project: Project) -> Iterator[Finding]:
    """Command interface is not exported by any hardware.

    The controller is loaded and configured, but cannot be activated. For each joint, the hardware exports the command
    interfaces listed in the `<ros2_control>` tag. A controller claims those that its parameters or its type name.
    """
    return of_each_candidate(project, lambda session, controller: unoffered(session, controller, ClaimKind.COMMAND))
