"""UC409."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, StageDependsOn, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC409",
    stage=StageDependsOn.PARAMETER_CHECKS,
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: a map in a list is read as if it were not in a list",
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
                    map_interface_to_joint_state:
                      - position: absolute_position
                      - «velocity: absolute_velocity»
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
                    map_interface_to_joint_state:
                      position: absolute_position
                      velocity: absolute_velocity
            """
        },
    ],
)
def map_in_list(project: Project) -> Iterator[Finding]:
    """List of maps (`- name: value`).

    Parameters of ROS 1 can be lists of maps; those of ROS 2 cannot. ROS 2 reads only the first map of such a list; the
    others are lost.
    """
    for fault in faults(project, FaultKind.MAP_IN_LIST):
        message = f"'{fault.subject}' is a list of maps; ROS 2 reads only the first. Write one map, without '-'"
        yield Finding(fault.at, message)
