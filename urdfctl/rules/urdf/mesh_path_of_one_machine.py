"""UC151."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in
from urdfctl.rules.urdf.mesh_addresses import in_packages

_OF_ONE_MACHINE = re.compile(r"(file:)?/|[A-Za-z]:[\\/]|~")


@rule(
    "UC151",
    runtime="works",
    because="RViz refuses it, and other machines do not have the file",
    severity=Severity.WARNING,
    authority="wiki.ros.org urdf/XML/link: a mesh is named by package://<packagename>/<path>",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><mesh filename="«file:///home/me/ws/src/arm_description/meshes/tool.stl»"/></geometry>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><mesh filename="file://$(find arm_description)/meshes/tool.stl"/></geometry>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "robot.xacro": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><mesh filename="file://$(find arm_description)/meshes/tool.stl"/></geometry>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
            "package.xml": """
                <package format="3"><name>arm_description</name></package>
            """,
            "meshes/tool.stl": """
                solid tool
                endsolid tool
            """,
        },
    ],
)
def mesh_path_of_one_machine(project: Project) -> Iterator[Finding]:
    """Absolute mesh path.

    The mesh is found only on the machine where the path was written. RViz accepts only package:// and file://
    addresses.
    """
    robot = robot_in(project)
    meshes = [
        mesh
        for mesh in (robot.meshes if robot else ())
        if _OF_ONE_MACHINE.match(mesh.filename)
        and is_known(mesh.filename)
        and mesh.at.span.text == mesh.filename
        and "$(" not in mesh.filename  # it is for xacro, which finds the package on each machine
    ]
    if meshes:
        first = meshes[0]
        more = f" (and {len(meshes) - 1} more)" if len(meshes) > 1 else ""
        problem = f"mesh of {label('link', first.link)} has the absolute path '{first.filename}'{more}"
        yield Finding(first.at, f"{problem}; write package://PACKAGE/PATH", fix=in_packages(meshes))
