"""UC026."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC026",
    severity=Severity.ERROR,
    authority="YAML 1.1, section 4.2.1: tabs must not be used for indentation; libyaml: 'found character that cannot start any token'",
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
    """A line of a controllers' file is indented with a tab.

    YAML forbids it, and no reader takes the file: ROS 2's node ends when it starts, ROS 1's roslaunch stops.
    """
    yield from findings_of(project, ProblemKind.YAML_TAB)
