"""UC408."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC408",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Sequence should be of same type'; 'Sequences cannot be key'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base: {type: diff_drive_controller/DiffDriveController}
                base:
                  ros__parameters:
                    left_wheel_names: [shoulder]
                    right_wheel_names: [elbow]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
                    pose_covariance_diagonal: [0.001, 0.001, «1», 1.0, 1.0, 0.03]
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base: {type: diff_drive_controller/DiffDriveController}
                base:
                  ros__parameters:
                    left_wheel_names: [shoulder]
                    right_wheel_names: [elbow]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
                    pose_covariance_diagonal: [0.001, 0.001, 1.0, 1.0, 1.0, 0.03]
            """
        },
    ],
)
def list_of_several_types(project: Project) -> Iterator[Finding]:
    """List with elements of several types, or with nested lists.

    In ROS 2 all elements of a list must have the same type, and 1 and 1.0 have different types. ROS 2 rejects the whole
    file.
    """
    for fault in faults(project, FaultKind.MIXED_LIST, FaultKind.NESTED_LIST):
        if fault.kind is FaultKind.NESTED_LIST:
            message = f"'{fault.subject}' contains a nested list, which ROS 2 parameters do not support"
        else:
            message = (
                f"element '{fault.at.span.text}' of '{fault.subject}' has another type than those before it; "
                "use one type for all (1 and 1.0 are different types)"
            )
        yield Finding(fault.at, message)
