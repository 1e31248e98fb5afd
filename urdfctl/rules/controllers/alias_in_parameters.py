"""UC405."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC405",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Will not support aliasing at line 8'",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def alias_in_parameters(project: Project) -> Iterator[Finding]:
    """A parameter file uses a YAML alias (`*name`).

    ROS 2's reader of parameter files knows no aliases: the node that is given the file ends at once. Anchors (`&name`)
    and merge keys that hold a map of their own do no harm.
    """
    for fault in faults(project, FaultKind.ALIAS):
        yield Finding(fault.at, "ROS 2 reads no YAML aliases; write here what the anchor stands for")
