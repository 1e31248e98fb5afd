"""UC152."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in
from urdfctl.rules.urdf.mesh_addresses import in_packages


@rule(
    "UC152",
    severity=Severity.WARNING,
    runtime="warns",
    authority="resource_retriever passes any address but package:// to libcurl: 'Could not load resource [...]'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><mesh filename="«meshes/tool.stl»"/></geometry>
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
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><mesh filename="package://arm_description/meshes/tool.stl"/></geometry>
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
def mesh_path_relative(project: Project) -> Iterator[Finding]:
    """Relative mesh path.

    The description is passed on as text, without the folder that it came from, so RViz prints an error and shows no
    mesh.
    """
    robot = robot_in(project)
    meshes = [
        mesh
        for mesh in (robot.meshes if robot else ())
        if mesh.filename and mesh.filename[0] not in "/~$" and ":" not in mesh.filename and is_known(mesh.filename)
    ]
    if meshes:
        first = meshes[0]
        more = f" (and {len(meshes) - 1} more)" if len(meshes) > 1 else ""
        problem = f"mesh of {label('link', first.link)} has the relative path '{first.filename}'{more}"
        yield Finding(first.at, f"{problem}; write package://PACKAGE/PATH", fix=in_packages(meshes))
