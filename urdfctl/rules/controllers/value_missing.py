"""UC406."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC406",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'No value at line 7'; ros_comm's rosparam: 'cannot marshal None "
    "unless allow_none is enabled'",
    options=["--distro=jazzy"],
    bad=[
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
                    «use_sim_time»:
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
def value_missing(project: Project) -> Iterator[Finding]:
    """Parameter or list element without a value.

    Parameters always have a value: ROS 2 rejects the whole file, and roslaunch (ROS 1) exits with an error. Write an
    empty string as ''. To use the default, remove the parameter.
    """
    for fault in faults(project, FaultKind.EMPTY):
        lack = "has no value" if fault.at.span.text == fault.subject else "has an element without a value"
        message = f"'{fault.subject}' {lack}; {_reader(project)} rejects the file. Add a value, or remove it"
        yield Finding(fault.at, message)


def _reader(project: Project) -> str:
    return "roslaunch" if project.ros == 1 else "ROS 2"
