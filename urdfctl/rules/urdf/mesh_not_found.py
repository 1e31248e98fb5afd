"""UC149."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Mesh
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in


@rule(
    "UC149",
    severity=Severity.WARNING,
    authority="resource_retriever: 'Could not load resource [...]'; urdfdom does not open meshes",
    bad={
        "robot.urdf": """
            <link name="tool">
              <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
              <visual>
                <geometry><mesh filename="«package://arm_description/meshes/tol.stl»"/></geometry>
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
def mesh_not_found(project: Project) -> Iterator[Finding]:
    """The file of a mesh does not exist.

    urdfdom does not look. RViz shows nothing there, and Gazebo leaves the shape out: the link touches nothing. Of a folder
    of which no mesh is there, the first one is told.
    """
    robot = robot_in(project)
    lost: dict[str, dict[str, Mesh]] = {}
    existing = set()
    for mesh in robot.meshes if robot else ():
        folder = mesh.filename.rpartition("/")[0]
        if mesh.file is None or not mesh.file.package_found or not is_known(mesh.filename):
            continue
        if mesh.file.exists:
            existing.add(folder)
        else:
            lost.setdefault(folder, {}).setdefault(mesh.filename, mesh)
    for folder, meshes in lost.items():
        told = list(meshes.values())
        more = "" if folder in existing or len(told) == 1 else f", nor any other of {len(told)} in its folder"
        for mesh in told[:1] if more else told:
            hint = f"; did you mean '{mesh.file.nearest}'?" if mesh.file and mesh.file.nearest and not more else ""
            yield Finding(mesh.at, f"no such file: '{mesh.filename}', a mesh of {label('link', mesh.link)}{more}{hint}")
