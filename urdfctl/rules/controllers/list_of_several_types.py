"""UC408."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC408",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Sequence should be of same type'; 'Sequences cannot be key'",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def list_of_several_types(project: Project) -> Iterator[Finding]:
    """A list holds values of several types, or lists.

    All elements of a list are of one type in ROS 2, and 1 is another type than 1.0: the reader refuses the whole file.
    """
    for fault in faults(project, FaultKind.MIXED_LIST, FaultKind.NESTED_LIST):
        if fault.kind is FaultKind.NESTED_LIST:
            message = f"'{fault.subject}' holds a list in a list, which no parameter of ROS 2 can"
        else:
            message = (
                f"'{fault.at.span.text}' is of another type than what stands before it in '{fault.subject}'; "
                "all elements must be of one, and 1 is another type than 1.0"
            )
        yield Finding(fault.at, message)
