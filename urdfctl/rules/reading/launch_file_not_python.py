"""UC027."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC027",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="launch launch/launch_description_sources/python_launch_file_utilities.py: the file is imported as a Python module; 'InvalidLaunchFileError'",
    bad=[
        {
            "arm.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    return LaunchDescription«»([Node(package='joint_state_publisher', executable='joint_state_publisher')]
            """,
        },
        {
            "arm.launch.py": """
                «»<launch>
                  <node pkg="joint_state_publisher" exec="joint_state_publisher"/>
                </launch>
            """,
        },
    ],
    good=[
        {
            "arm.launch.py": """
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    return LaunchDescription([Node(package='joint_state_publisher', executable='joint_state_publisher')])
            """,
        },
    ],
)
def launch_file_not_python(project: Project) -> Iterator[Finding]:
    """Launch file has a Python syntax error.

    launch imports the file as a Python module and stops with the same error, so nothing in it is started. urdfctl does
    not check the rest of the file.
    """
    yield from findings_of(project, ProblemKind.PYTHON_SYNTAX)
