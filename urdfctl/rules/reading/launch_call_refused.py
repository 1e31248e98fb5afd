"""UC037."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind

_LAUNCH = """
    import os
    from ament_index_python.packages import get_package_share_directory
    from launch import LaunchDescription
    from launch.actions import IncludeLaunchDescription
    from launch.launch_description_sources import PythonLaunchDescriptionSource
    from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
    from launch_ros.actions import Node
    from launch_ros.substitutions import FindPackageShare


    def generate_launch_description():
        {}
"""
_NODE = "package='teleop', executable='teleop'"
_OTHER = "PythonLaunchDescriptionSource('/opt/arm.launch.py')"


def _files(*lines: str, function: str = "generate_launch_description") -> dict[str, str]:
    text = _LAUNCH.format("\n        ".join(lines))
    return {"arm.launch.py": text.replace("def generate_launch_description", f"def {function}")}


def _describes(action: str) -> dict[str, str]:
    return _files(f"return LaunchDescription([{action}])")


@rule(
    "UC037",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="launch launch_description.py, python_launch_file_utilities.py ('does not contain the required function'), "
    "actions/include_launch_description.py; launch_ros actions/node.py: \"Expected 'parameters' to be one of\", "
    "'cmd += arguments'; os.path.join(): a part that begins with / discards those before it",
    bad=[
        _files("return «LaunchDescription»(None, None)"),
        _describes(f"Node({_NODE}, parameters=«{{'rate': 1}}»)"),
        _describes(f"Node({_NODE}, arguments=«'--fast'»)"),
        _describes("«Node»(package='teleop')"),
        _describes(f"IncludeLaunchDescription({_OTHER}, launch_arguments=«{{'world': 'a'}}»)"),
        _describes(f"IncludeLaunchDescription({_OTHER}, launch_arguments={{'sim': «True»}}.items())"),
        _files(
            "folder = FindPackageShare('arm')", "path = os.path.join(«folder», 'urdf')", "return LaunchDescription([])"
        ),
        _files("path = PathJoinSubstitution([FindPackageShare('arm'), «'/urdf'»])", "return LaunchDescription([])"),
        _files("path = os.path.join(get_package_share_directory('launch'), «'/urdf'»)", "return LaunchDescription([])"),
        _files("path = «FindPackageShare('arm') + '/urdf'»", "return LaunchDescription([])"),
        _files("«LaunchDescription([])»"),
        _files("«return LaunchDescription([])»", function="generate_launch_descriptions"),
        _files("«return LaunchDescription([])»", function="generate_launch_description_real"),
    ],
    good=[
        _files("return LaunchDescription(None)"),
        _describes(f"Node({_NODE}, parameters=[{{'rate': 1}}], arguments=['--fast'])"),
        _describes("Node(**{'package': 'teleop', 'executable': 'teleop'})"),
        _describes(f"IncludeLaunchDescription({_OTHER}, launch_arguments={{'sim': 'true'}}.items())"),
        _files("path = PathJoinSubstitution([FindPackageShare('arm'), 'urdf'])", "return LaunchDescription([])"),
        _files("path = os.path.join(get_package_share_directory('launch'), 'urdf')", "return LaunchDescription([])"),
    ],
)
def launch_call_refused(project: Project) -> Iterator[Finding]:
    """Launch file in Python that launch refuses.

    A list is missing around actions, parameters or arguments, an argument that a call requires is not there, a
    substitution is used as a text, or the function does not return the launch description. launch stops with an exception,
    and starts nothing; of a text as `arguments`, the program gets the single letters. Only what certainly runs is told.
    """
    yield from findings_of(project, ProblemKind.PYTHON_CALL)
