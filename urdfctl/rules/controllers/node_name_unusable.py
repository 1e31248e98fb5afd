"""UC411."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC411",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c checks each name with rmw_validate_node_name and rmw_validate_namespace",
    options=["--distro=jazzy"],
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
            «arm-controller»:
              ros__parameters:
                joints: [shoulder, elbow]
        """
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
            another_node:
              ros__parameters:
                joints: [shoulder, elbow]
        """
    },
)
def node_name_unusable(project: Project) -> Iterator[Finding]:
    """The key before `ros__parameters` can be no name of a node.

    Names of nodes and namespaces are made of letters, digits and underscores, and begin with no digit; `*` and `**`
    stand for whole parts. ROS 2's reader refuses the whole file otherwise.
    """
    for fault in faults(project, FaultKind.NODE_NAME):
        if fault.subject:
            message = (
                f"'{fault.subject}' is no name of a node: only letters, digits and underscores, no digit at the start"
            )
        else:
            message = (
                "'ros__parameters' stands below no name of a node; write one above it, such as 'controller_manager:'"
            )
        yield Finding(fault.at, message)
