"""UC406."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC406",
    severity=Severity.ERROR,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'No value at line 7'; ros_comm's rosparam: 'cannot marshal None "
    "unless allow_none is enabled'",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def value_missing(project: Project) -> Iterator[Finding]:
    """A parameter, or an element of a list, has no value.

    Neither ROS 1 nor ROS 2 has parameters without one: ROS 2's reader refuses the whole file, roslaunch ends with an
    error. An empty text is written '', and a parameter that shall keep its default is left out.
    """
    for fault in faults(project, FaultKind.EMPTY):
        what = "has no value" if fault.at.span.text == fault.subject else "holds an element without value"
        yield Finding(fault.at, f"'{fault.subject}' {what}, which {_reader(project)} refuses; give one, or take it out")


def _reader(project: Project) -> str:
    return "roslaunch" if project.ros == 1 else "ROS 2's reader of parameters"
