"""UC036."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


def _launch(before: str, started: str) -> dict[str, str]:
    text = f"""
        from launch import LaunchDescription
        from launch.actions import ExecuteProcess
        from launch_ros.actions import Node


        def generate_launch_description():
            states = Node(package='joint_state_publisher', executable='joint_state_publisher')
            {before} = Node(package='robot_state_publisher', executable='robot_state_publisher', arguments=['arm.urdf'])
            return LaunchDescription([{started}])
    """
    return {"arm.launch.py": text, "arm.urdf": ""}


@rule(
    "UC036",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="launch launch_description.py: only the entities of the LaunchDescription that generate_launch_description() returns "
    "are visited",
    bad=[_launch("«publisher»", "states")],
    good=[
        _launch("publisher", "states, publisher"),
        _launch("publisher", "\n                states,\n                # publisher,\n            "),
    ],
)
def launch_action_unused(project: Project) -> Iterator[Finding]:
    """Action of a launch file is created, but not started.

    launch runs what the LaunchDescription contains, and what that starts in turn. A node that is only assigned to a name
    never runs, and nothing says so. If its use is a comment, it is off on purpose.
    """
    yield from findings_of(project, ProblemKind.ACTION_UNUSED)
