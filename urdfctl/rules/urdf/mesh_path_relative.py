"""UC152."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in
from urdfctl.rules.urdf.mesh_addresses import in_packages


@rule(
    "UC152",
    severity=Severity.WARNING,
    authority="resource_retriever asks libcurl for what is no package:// address: 'Could not load resource [...]'",
    bad={
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
    good={
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
)
def mesh_path_relative(project: Project) -> Iterator[Finding]:
    """A mesh is named by a relative path.

    The description travels as a text, and nobody knows the folder that it came from: RViz shows no such mesh.
    """
    robot = robot_in(project)
    found = [
        mesh
        for mesh in (robot.meshes if robot else ())
        if mesh.filename and mesh.filename[0] not in "/~$" and ":" not in mesh.filename and is_known(mesh.filename)
    ]
    if found:
        first = found[0]
        more = f", and {len(found) - 1} more" if len(found) > 1 else ""
        what = f"the mesh of {label('link', first.link)} is the relative path '{first.filename}'{more}"
        yield Finding(first.at, f"{what}; write package://PACKAGE/PATH", fix=in_packages(found))
