"""UC031."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, Stage, rule


@rule(
    "UC031",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Cannot have a value before ros__parameters at line 1'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                «ros__parameters»:
                update_rate: 100
                arm:
                type: forward_command_controller/ForwardCommandController
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm:
                      type: forward_command_controller/ForwardCommandController
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
            """
        },
    ],
)
def indentation_lost(project: Project) -> Iterator[Finding]:
    """`ros__parameters` is beside its node's name, not below it.

    In YAML only the indentation says what belongs to what. The node has no value, the parameters belong to no node, and
    ROS 2 rejects the file. Other findings in the file would only follow from it and are left out.
    """
    for fault in controllers_in(project).faults:
        if fault.kind is not FaultKind.LOST_INDENTATION:
            continue
        message = f"'ros__parameters' is not indented below '{fault.subject}'; ROS 2 rejects the file. Indent it, and "
        yield Finding(fault.at, message + "its parameters below it")
