"""UC035."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


def _launch(share: str, folder: str) -> str:
    return f"""
        from ament_index_python.packages import get_package_share_directory
        from launch import LaunchDescription
        from launch.actions import DeclareLaunchArgument


        def generate_launch_description():
            {share} = get_package_share_directory('launch')
            return LaunchDescription([DeclareLaunchArgument('model', default_value={folder} + '/arm.urdf')])
    """


@rule(
    "UC035",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='Python: NameError; launch launch_service.py: "Caught exception in launch (see debug for traceback): name '
    "'desc_dir' is not defined\"",
    bad=[{"arm.launch.py": _launch("share_dir", "«desc_dir»")}],
    good=[{"arm.launch.py": _launch("desc_dir", "desc_dir")}],
)
def launch_name_undefined(project: Project) -> Iterator[Finding]:
    """Undefined name in a launch file in Python.

    launch calls the function and stops with the NameError, so nothing is started. Only names that nothing in the file
    defines are told, where they are certainly looked up.
    """
    yield from findings_of(project, ProblemKind.PYTHON_NAME)
