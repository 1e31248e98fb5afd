"""UC039."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


def _launch(condition: str, value: str = "LaunchConfiguration('gui')") -> dict[str, str]:
    text = f"""
        from launch import LaunchDescription
        from launch.actions import DeclareLaunchArgument, OpaqueFunction
        from launch.substitutions import LaunchConfiguration
        from launch_ros.actions import Node


        def nodes(context):
            gui = {value}
            states = Node(package='joint_state_publisher', executable='joint_state_publisher')
            if {condition}:
                states = Node(package='joint_state_publisher_gui', executable='joint_state_publisher_gui')
            return [states]


        def generate_launch_description():
            declared = DeclareLaunchArgument('gui', default_value='true')
            publisher = Node(package='robot_state_publisher', executable='robot_state_publisher', arguments=['arm.urdf'])
            return LaunchDescription([declared, publisher, OpaqueFunction(function=nodes)])
    """
    return {"arm.launch.py": text, "arm.urdf": ""}


@rule(
    "UC039",
    severity=Severity.WARNING,
    runtime="misbehaves",
    distros=ROS2,
    authority="ros2/launch launch/launch/substitution.py: Substitution has neither __eq__ nor __bool__; perform(context) gives the "
    "text",
    bad=[
        _launch("«gui == 'true'»"),
        _launch("«'true' != gui»"),
        _launch("«gui in ('true', '1')»"),
        _launch("«gui»"),
        _launch("«not gui»"),
    ],
    good=[
        _launch("gui == 'true'", "LaunchConfiguration('gui').perform(context)"),
        _launch("context.launch_configurations['gui'] == 'true'"),
        _launch("gui is not None"),
    ],
)
def launch_argument_compared(project: Project) -> Iterator[Finding]:
    """Launch argument is compared before it has a value.

    LaunchConfiguration is an object that launch replaces by the argument's text when it uses it. Python compares the object,
    which equals no text and is always true. The condition is the same whatever the argument is. Give the action a
    `condition=IfCondition(...)`, or ask for the text in an OpaqueFunction: LaunchConfiguration('x').perform(context).
    """
    yield from findings_of(project, ProblemKind.ARGUMENT_COMPARED)
