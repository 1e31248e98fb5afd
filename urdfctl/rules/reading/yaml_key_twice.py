"""UC025."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import FaultKind
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC025",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="rcl_yaml_param_parser/src/parse.c: parse_value() overwrites; PyYAML: construct_mapping() keeps the last one",
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm:
                      type: joint_trajectory_controller/JointTrajectoryController
                arm:
                  ros__parameters:
                    joints: [shoulder]
                    command_interfaces: [position]
                    state_interfaces: [position]
                    «joints»: [elbow]
            """,
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm:
                      type: joint_trajectory_controller/JointTrajectoryController
            """,
        },
    ],
)
def yaml_key_twice(project: Project) -> Iterator[Finding]:
    """Duplicate key in a map.

    No program reports it. If the values are not maps, the first one is lost. If both are maps, rosparam keeps only the
    last one. ROS 2 nodes merge them, but the spawner and launch files read YAML with Python and see only the last one.
    """
    faults = project.controllers.faults if project.controllers else ()
    lost = {fault.at.source.path for fault in faults if fault.kind is FaultKind.LOST_INDENTATION}  # UC031 reports it
    for finding in findings_of(project, ProblemKind.YAML_DUPLICATE_KEY):
        if finding.at.source.path not in lost:
            yield finding
    severity = Severity.INFO if project.ros == 2 else None  # noqa: PLR2004
    for finding in findings_of(project, ProblemKind.YAML_DUPLICATE_MAP):
        yield finding._replace(severity=severity)
