"""UC674."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.moveit.samples import KINEMATICS, SEMANTIC

_PYTHON = """
    import os
    import yaml
    from ament_index_python.packages import get_package_share_directory
    from launch import LaunchDescription
    from launch_ros.actions import Node


    def generate_launch_description():
        folder = get_package_share_directory('arm')
        with open(os.path.join(folder, 'arm.urdf')) as file:
            described = {'robot_description': file.read()}
        with open(os.path.join(folder, 'kinematics.yaml')) as file:
            kinematics = PARAMETERS
        group = Node(package='moveit_ros_move_group', executable='move_group', parameters=[described, kinematics])
        return LaunchDescription([group])
"""
_LOADED = "yaml.safe_load(file)"


def _files(parameters: str, kinematics: str = KINEMATICS) -> dict[str, str]:
    return {
        "arm.urdf": "",
        "arm.launch.py": _PYTHON.replace("PARAMETERS", parameters),
        "kinematics.yaml": kinematics,
        "arm.srdf": SEMANTIC,
        "package.xml": """
            <package format="3"><name>arm</name><exec_depend>moveit_ros_move_group</exec_depend></package>
        """,
    }


@rule(
    "UC674",
    severity=Severity.ERROR,
    runtime="drops",
    distros=since("jazzy"),
    options=("--distro=jazzy",),
    authority="moveit2 kinematics_plugin_loader.cpp getLoaderFunction(): since jazzy only robot_description_kinematics.<group> is "
    "read, until humble also <group>; 'No kinematics plugins defined. Fill and load kinematics.yaml!'",
    bad=[_files(_LOADED, KINEMATICS.replace("arm:", "«arm»:"))],
    good=[_files(f"{{'robot_description_kinematics': {_LOADED}}}")],
)
def kinematics_without_prefix(project: Project) -> Iterator[Finding]:
    """kinematics.yaml is passed without robot_description_kinematics.

    MoveIt looks for the solver of a group below robot_description_kinematics. Until humble it also looked beside it.
    Without a solver, goals for the tip of the group fail.
    """
    moveit = project.moveit
    if moveit is None or moveit.files is None or not moveit.files.bare_kinematics or not moveit.solvers:
        return
    if set(project.distros) <= set(since("jazzy")):
        at = moveit.solvers[0].group.at
        message = "MoveIt does not find these solvers: pass them as {'robot_description_kinematics': ...}"
        yield Finding(at, message, (Note("they are passed to the node here", moveit.files.at),))
