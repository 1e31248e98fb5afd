"""UC616."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.launch import LaunchedFile
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.file_names import file_renamed, meant_file
from urdfctl.rules.launch_samples import BROADCASTER, MANAGER, PUBLISHER, SOUND, launched, spawner

_NEEDED = {
    "description": "robot description",
    "parameters": "parameter file",
    "include": "included launch file",
    "text": "file of a parameter",
}
"""The uses for which a file must exist, and what messages call such a file."""
_ARGUMENTS = {
    ".rviz": "RViz configuration",
    ".vcg": "RViz configuration",
    ".world": "world file",
    ".sdf": "SDF file",
    ".yaml": "configuration file",
    ".yml": "configuration file",
    ".urdf": "robot description",
    ".xacro": "robot description",
    ".srdf": "SRDF file",
}
"""The endings of files that programs, parameters and included launch files get, and what messages call such a file."""


@rule(
    "UC616",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="roslaunch: 'file does not exist'; roslaunch loader.py param_value(): opens textfile and binfile; launch: 'The following exception occurred ... No such file or directory'; "
    "rcl: 'Error opening YAML file'; xacro: 'No such file or directory'; "
    "moveit_configs_utils launches.py generate_demo_launch(): includes launch/rsp.launch.py and others of the package; "
    "ros_gz_bridge bridge_config.cpp readFromYamlFile(): 'Could not parse config: failed to open file'",
    bad=[
        launched(
            PUBLISHER,
            MANAGER,
            BROADCASTER,
            spawner("arm_controller -p «$(find-pkg-share arm)/controler.yaml»"),
        ),
        launched(
            PUBLISHER.replace("$(command", "«$(command").replace("arm.urdf')", "model.urdf')»"),
            """
      <include file="«$(find-pkg-share arm)/spawn.launch.xml»"/>
      <node pkg="rviz2" exec="rviz2" args="-d «$(find-pkg-share arm)/arm.rviz»"/>
      <node pkg="ros_gz_sim" exec="create" args="-file «$(find-pkg-share arm)/arm.sdf»"/>
      <node pkg="ros_gz_bridge" exec="parameter_bridge">
        <param name="config_file" value="«$(find-pkg-share arm)/bridge.yaml»"/>
        <param name="more" value="«$(find-pkg-share arm)/bridge.yml»"/>
        <param name="urdf" value="«$(find-pkg-share arm)/tool.urdf»"/>
        <param name="xacro" value="«$(find-pkg-share arm)/tool.xacro»"/>
        <param name="srdf" value="«$(find-pkg-share arm)/tool.srdf»"/>
      </node>""",
        ),
        {
            "arm.launch": """
                <launch>
                  <include file="$(find gazebo_ros)/launch/empty_world.launch">
                    <arg name="world_name" value="«$(find arm)/arm.world»"/>
                  </include>
                  <node name="rviz" pkg="rviz" type="rviz" args="«-d $(find arm)/arm.vcg»"/>
                  <param name="tool" textfile="«$(find arm)/tool.urdf»"/>
                </launch>
            """,
            "package.xml": "<package><name>arm</name></package>",
        },
        {
            "launch/demo.launch.py": """
                from moveit_configs_utils import MoveItConfigsBuilder
                from moveit_configs_utils.launches import generate_demo_launch

                def generate_launch_description():
                    config = MoveItConfigsBuilder("arm", package_name="arm").to_moveit_configs()
                    return «generate_demo_launch(config)»
            """,
            "launch/rsp.launch.py": "",
            "launch/spawn_controllers.launch.py": "",
            "package.xml": "<package format='3'><name>arm</name></package>",
        },
    ],
    good=[SOUND],
)
def launched_file_missing(project: Project) -> Iterator[Finding]:
    """Launch file uses a file that does not exist.

    The file is the robot description, a parameter file or another launch file. The launch stops there, or the node that
    reads the file exits. A file that a program, a parameter or an included launch file gets is a warning if the folder has
    other such files or is missing too, and worth knowing if the file may be made later: without its world the simulator
    exits or is empty, without its configuration a bridge bridges nothing, and RViz starts with a default view.
    """
    references = project.launch.references if project.launch else ()
    needed = {reference.file.path for reference in references if reference.use in _NEEDED}
    for reference in references:
        if reference.file.exists is False and reference.use in _NEEDED:
            severity = None if reference.sure else Severity.WARNING
            message = f"{_NEEDED[reference.use]} does not exist: '{_shown(reference, project)}'"
            message += meant_file(reference.file)
            yield Finding(reference.file.at, message, fix=file_renamed(reference.file), severity=severity)
        elif reference.file.exists is False and reference.use == "argument" and reference.file.path not in needed:
            kind = next((kind for end, kind in _ARGUMENTS.items() if (reference.file.path or "").endswith(end)), None)
            if kind and reference.sure:
                message = f"{kind} does not exist: '{_shown(reference, project)}'{meant_file(reference.file)}"
                severity = Severity.WARNING if reference.has_siblings else Severity.INFO
                yield Finding(reference.file.at, message, fix=file_renamed(reference.file), severity=severity)


def _shown(reference: LaunchedFile, project: Project) -> str:
    """Return a file's path, starting with the package name if it is in the package."""
    path = reference.file.path or reference.file.text
    package = project.launch.package if project.launch else None
    if package is None or not path.startswith(f"{package.folder}/"):
        return path
    return f"{package.name}/{path.removeprefix(package.folder).lstrip('/')}"
