"""UC026."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC026",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="YAML 1.1, section 4.2.1: tabs must not be used for indentation; PyYAML (roslaunch's reader) scanner.py: scan_to_next_token() skips blanks only",
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                «\t»ros__parameters:
                \t\tupdate_rate: 100
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
def yaml_tab(project: Project) -> Iterator[Finding]:
    """Tab in a controller file where YAML does not allow it.

    YAML does not allow tabs in the indentation, and every program rejects the file. A ROS 2 node exits at start, and
    roslaunch in ROS 1 stops. rosparam reads YAML with Python and also rejects tabs after a colon or a dash.
    """
    yield from findings_of(project, ProblemKind.YAML_TAB)
