"""UC407."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import controllers_in, faults


@rule(
    "UC407",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="rclcpp rclcpp/src/rclcpp/parameter_map.cpp: 'No parameter value set'",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def collection_empty(project: Project) -> Iterator[Finding]:
    """A list or a map of parameters is empty.

    An empty list has no type that ROS 2's reader could tell, and the node that is given it fails, even where it does not
    know the parameter: the controller is not loaded, or the controller manager ends. To have the default, leave it out.
    """
    others = {section.path for section in controllers_in(project).others}
    for fault in faults(project, FaultKind.EMPTY_COLLECTION):
        own = "/".join(key.text for key in fault.keys) not in others
        message = (
            f"'{fault.subject}' is empty, and the node that reads it fails ('No parameter value set'); leave it out"
        )
        yield Finding(fault.at, message, severity=None if own else Severity.WARNING)
