"""UC026."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC026",
    severity=Severity.ERROR,
    authority="YAML 1.1, section 4.2.1: tabs must not be used for indentation; PyYAML (roslaunch's reader) scanner.py: scan_to_next_token() skips blanks only",
    bad={
        "controllers.yaml": """
            controller_manager:
            «\t»ros__parameters:
            \t\tupdate_rate: 100
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
def yaml_tab(project: Project) -> Iterator[Finding]:
    """A tab stands in a controllers' file where its reader takes none.

    YAML forbids tabs in the indentation, and no reader takes the file: ROS 2's node ends when it starts, ROS 1's
    roslaunch stops. rosparam, which reads YAML with Python, takes none behind a colon or a dash either.
    """
    yield from findings_of(project, ProblemKind.YAML_TAB)
