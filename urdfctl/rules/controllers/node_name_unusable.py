"""UC411."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.controllers.common import faults


@rule(
    "UC411",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c checks each name with rmw_validate_node_name and rmw_validate_namespace",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                «arm-controller»:
                  ros__parameters:
                    joints: [shoulder, elbow]
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                another_node:
                  ros__parameters:
                    joints: [shoulder, elbow]
            """
        },
    ],
)
def node_name_unusable(project: Project) -> Iterator[Finding]:
    """Invalid node name.

    The key before `ros__parameters` names a node. Names of nodes and namespaces consist of letters, digits and
    underscores, and do not start with a digit; `*` and `**` replace whole parts. ROS 2 rejects a file with other names.
    """
    for fault in faults(project, FaultKind.NODE_NAME):
        if fault.subject:
            message = (
                f"node name '{fault.subject}' is invalid; "
                "use only letters, digits and underscores, and no digit at the start"
            )
        else:
            message = "'ros__parameters' has no node name above it; add one, e.g. 'controller_manager:'"
        yield Finding(fault.at, message)
