"""UC024."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC024",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="rcl_yaml_param_parser/src/parse.c: 'Error parsing a event near line %d'; roslaunch: 'file <f> contains invalid YAML'",
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm:
                      type: joint_trajectory_controller«:» JointTrajectoryController
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
def yaml_not_readable(project: Project) -> Iterator[Finding]:
    """Controller file is not valid YAML.

    A ROS 2 node exits at start ("Couldn't parse params file"), and roslaunch in ROS 1 stops. Nothing in the file is
    used.
    """
    yield from findings_of(project, ProblemKind.YAML_SYNTAX)
