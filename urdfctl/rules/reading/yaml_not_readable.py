"""UC024."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC024",
    severity=Severity.ERROR,
    authority="rcl_yaml_param_parser/src/parse.c: 'Error parsing a event near line %d'; roslaunch: 'file <f> contains invalid YAML'",
    bad={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                arm:
                  type: joint_trajectory_controller«:» JointTrajectoryController
        """,
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                arm:
                  type: joint_trajectory_controller/JointTrajectoryController
        """,
    },
)
def yaml_not_readable(project: Project) -> Iterator[Finding]:
    """A controllers' file is not YAML.

    ROS 2's node ends when it starts ("Couldn't parse params file"), ROS 1's roslaunch stops: nothing of the file is
    read.
    """
    yield from findings_of(project, ProblemKind.YAML_SYNTAX)
