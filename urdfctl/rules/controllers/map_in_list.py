"""UC409."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC409",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: a list holds plain values only",
    options=["--distro=jazzy"],
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
            joint_states:
              ros__parameters:
                extra_joints:
                  - «name: caster»
        """
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
            joint_states:
              ros__parameters:
                extra_joints:
                  - caster
        """
    },
)
def map_in_list(project: Project) -> Iterator[Finding]:
    """A list holds maps (`- name: value`).

    ROS 1 had parameters that are lists of maps. ROS 2 has none: the reader takes the file, and what stands there is lost
    or read as something else.
    """
    for fault in faults(project, FaultKind.MAP_IN_LIST):
        message = f"'{fault.subject}' holds a map in a list, which is lost: a list of ROS 2 holds plain values only"
        yield Finding(fault.at, message)
