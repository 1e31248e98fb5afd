"""UC150."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in


@rule(
    "UC150",
    severity=Severity.WARNING,
    runtime="warns",
    authority="resource_retriever: 'Package [...] does not exist'; urdfdom does not open meshes",
    bad={
        "robot.urdf": """
            <link name="tool">
              <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
              <visual>
                <geometry><mesh filename="«package://arm_desciption/meshes/tool.stl»"/></geometry>
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
def mesh_package_not_found(project: Project) -> Iterator[Finding]:
    """Mesh package was not found.

    RViz and Gazebo print an error and leave out the shape. For a package that is installed elsewhere, declare it in
    package.xml, source its environment or use --package-path.
    """
    robot = robot_in(project)
    meshes_by_package: dict[str, int] = {}
    files = ((mesh, mesh.file) for mesh in (robot.meshes if robot else ()))
    lost = [mesh for mesh, file in files if file and not file.package_found and not file.package_declared]
    for mesh in lost:
        package = mesh.file.package if mesh.file else None
        meshes_by_package[package or ""] = meshes_by_package.get(package or "", 0) + 1
    for mesh in lost:
        package = (mesh.file.package if mesh.file else None) or ""
        meshes = meshes_by_package.pop(package, 0)
        if meshes and is_known(package):
            hint = f"; did you mean '{mesh.file.nearest}'?" if mesh.file and mesh.file.nearest else ""
            count = f" ({meshes} meshes)" if meshes > 1 else ""
            yield Finding(mesh.at, f"mesh package '{package}' was not found in this workspace{count}{hint}")
