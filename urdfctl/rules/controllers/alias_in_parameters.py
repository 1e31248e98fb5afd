"""UC405."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC405",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Will not support aliasing at line 8'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: &interfaces [position]
                    state_interfaces: «*interfaces»
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
                    state_interfaces: [position]
            """
        },
    ],
)
def alias_in_parameters(project: Project) -> Iterator[Finding]:
    """YAML alias in a parameter file.

    ROS 2's parameter file reader does not support aliases (`*name`): a node that gets this file exits at once. Anchors
    (`&name`) and merge keys with an inline map are harmless.
    """
    for fault in faults(project, FaultKind.ALIAS):
        message = f"YAML alias '{fault.at.span.text}' is not supported by ROS 2; write the value of the anchor instead"
        yield Finding(fault.at, message)
