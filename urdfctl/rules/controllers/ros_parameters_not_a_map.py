"""UC410."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, StageDependsOn, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC410",
    stage=StageDependsOn.PARAMETER_CHECKS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: parameters are the keys of a map",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  «ros__parameters»:
                    - joints: [shoulder, elbow]
                    - interface_name: position
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
            """
        },
    ],
)
def ros_parameters_not_a_map(project: Project) -> Iterator[Finding]:
    """`ros__parameters` is not a map.

    A list or a string gives no parameters to the node; a controller that requires parameters is not loaded.
    """
    for fault in faults(project, FaultKind.PARAMETERS_NOT_A_MAP):
        message = f"'ros__parameters' of '{fault.subject}' is not a map; the node requires 'name: value' lines"
        yield Finding(fault.at, message)
