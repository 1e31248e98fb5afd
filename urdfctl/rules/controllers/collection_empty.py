"""UC407."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC407",
    stage=Stage.LOAD,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="rclcpp rclcpp/src/rclcpp/parameter_map.cpp: 'No parameter value set'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
                joint_states:
                  ros__parameters:
                    «extra_joints»: []
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
                joint_states:
                  ros__parameters:
                    extra_joints: [caster]
            """
        },
    ],
)
def collection_empty(project: Project) -> Iterator[Finding]:
    """Empty list or map of parameters.

    ROS 2 cannot determine the type of an empty list. A node that gets one fails, even if it has no such parameter: the
    controller is not loaded, or the controller manager exits. To use the default, remove the parameter.
    """
    paths_of_other_nodes = {section.path for section in controllers_in(project).others}
    for fault in faults(project, FaultKind.EMPTY_COLLECTION):
        of_controller = "/".join(key.text for key in fault.keys) not in paths_of_other_nodes
        message = (
            f"parameter '{fault.subject}' is empty; the node fails with 'No parameter value set'. "
            "Remove it or give it a value"
        )
        yield Finding(fault.at, message, severity=None if of_controller else Severity.WARNING)
