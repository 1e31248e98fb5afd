"""UC451."""

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
    "UC451",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control controller_manager/src/controller_manager.cpp: \"Unable to activate controller 'arm' since "
    "the state interface 'shoulder/velocity' is not available.\", before jazzy: \"State interface with key "
    "'shoulder/velocity' does not exist\"",
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
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
                    state_interfaces: [position, «velocity»]
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
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
                    state_interfaces: [position]
            """,
        },
    ],
)
def state_interface_not_exported(project: Project) -> Iterator[Finding]:
    """State interface is not exported by any hardware.

    The controller is loaded and configured, but cannot be activated. A joint, sensor or gpio exports only the state
    interfaces listed in the `<ros2_control>` tag: a joint that exports its position does not also export its velocity.
    """
    return of_each_candidate(project, lambda session, controller: unoffered(session, controller, ClaimKind.STATE))
