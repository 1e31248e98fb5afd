"""UC636."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.launch import Launch
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in
from urdfctl.rules.launch.common import ROS_2, launch_of
from urdfctl.rules.launch_samples import PUBLISHER

_MOVED = rb"MODEL_PATH|RESOURCE_PATH|(?:replace|sub)\(\s*[rf]{0,2}[\"'](?:package|model)://"
"""In a launch file that sets the path, or that writes other addresses of meshes into the description."""
_NAMES = {"gazebo-classic": ("Gazebo Classic", "GAZEBO_MODEL_PATH"), "gz": ("gz", "GZ_SIM_RESOURCE_PATH")}
_PACKAGE = "package://"
_EXPORT = '<export><gazebo_ros gazebo_model_path="${prefix}/.."/></export>'
_CLASSIC = '<include file="$(find-pkg-share gazebo_ros)/launch/gazebo.launch.py"/>'
_GZ = '<include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"/>'


_REPLACED = """
    import os
    import xacro
    from ament_index_python.packages import get_package_share_directory
    from launch import LaunchDescription
    from launch.actions import IncludeLaunchDescription
    from launch_ros.actions import Node


    def generate_launch_description():
        share = get_package_share_directory("arm")
        text = xacro.process_file(os.path.join(share, "arm.urdf")).toxml()
        text = text.replace("package://arm", "file://" + share)
        world = os.path.join(get_package_share_directory("gazebo_ros"), "launch", "gazebo.launch.py")
        return LaunchDescription([
            IncludeLaunchDescription(world),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": text}],
            ),
        ])
"""


def _files(included: str, export: str = "") -> dict[str, str]:
    return {
        "arm.urdf": """
            <link name="tool">
              <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
              <visual><geometry><mesh filename="package://arm/tool.stl"/></geometry></visual>
            </link>
            <joint name="wrist" type="fixed"><parent link="fore"/><child link="tool"/></joint>
        """,
        "arm.launch.xml": f"""
            <launch>
              {included}{PUBLISHER}
            </launch>
        """,
        "package.xml": f"""
            <package format="3">
              <name>arm</name>
              <exec_depend>gazebo_ros</exec_depend>
              <exec_depend>robot_state_publisher</exec_depend>
              <exec_depend>ros_gz_sim</exec_depend>
              <exec_depend>xacro</exec_depend>
              {export}
            </package>
        """,
        "tool.stl": "solid tool\nendsolid tool",
    }


@rule(
    "UC636",
    severity=Severity.WARNING,
    runtime="warns",
    distros=ROS2,
    options=("--distro=foxy",),
    authority="sdformat parser_urdf.cc: package:// becomes model://; gazebo_ros and ros_gz_sim scripts GazeboRosPaths: the model "
    "path is taken from <export><gazebo_ros gazebo_model_path=.../></export>; 'No mesh specified', 'Unable to find file "
    "with URI [model://arm/tool.stl]'",
    bad=[_files(f"«{_CLASSIC}»"), _files(f"«{_GZ}»")],
    good=[
        _files(_CLASSIC, _EXPORT),
        _files(f'<set_env name="GAZEBO_MODEL_PATH" value="$(find-pkg-share arm)/.."/>{_CLASSIC}'),
        _files(f'<set_env name="GZ_SIM_RESOURCE_PATH" value="$(find-pkg-share arm)/.."/>{_GZ}'),
        {**{name: text for name, text in _files("").items() if "launch" not in name}, "arm.launch.py": _REPLACED},
    ],
)
def mesh_not_on_model_path(project: Project) -> Iterator[Finding]:
    """Gazebo does not find the meshes of a package.

    Gazebo reads package:// as model:// and looks for the package in its model path. A package adds itself to that path
    with an export in package.xml, or the launch file sets the environment variable. Otherwise Gazebo prints an error,
    and the links are invisible and have no collision shapes, unless the variable is set outside.
    """
    launch, robot = launch_of(project, ROS_2), robot_in(project)
    package = launch.package if launch else None
    simulation = next((each for each in launch.simulations if each.sure), None) if launch else None
    if launch is None or robot is None or package is None or simulation is None or _sets_path(launch):
        return
    for mesh in robot.meshes:
        name = mesh.filename.removeprefix(_PACKAGE).partition("/")[0]
        is_found = mesh.file is not None and mesh.file.exists
        if mesh.filename.startswith(_PACKAGE) and is_known(name) and is_found and package.shares_models(name) is False:
            simulator, variable = _NAMES.get(simulation.simulator, ("Gazebo", "GAZEBO_MODEL_PATH"))
            message = (
                f"{simulator} does not find the meshes of package '{name}'; add {_EXPORT} to its package.xml, "
                f"or set {variable}"
            )
            yield Finding(simulation.at, message, (Note("the first mesh is here", mesh.at),))
            return


def _sets_path(launch: Launch) -> bool:
    """Whether a launch file names a model path in any way, or replaces the addresses of meshes."""
    places = (*(node.at for node in launch.nodes), *(each.at for each in launch.simulations))
    described = (each.at for each in launch.descriptions)
    sources = {place.source.path: place.source for place in (*places, *described)}
    return any(re.search(_MOVED, source.data) for source in sources.values())
