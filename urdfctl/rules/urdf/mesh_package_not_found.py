"""UC150."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in


@rule(
    "UC150",
    severity=Severity.WARNING,
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
    """The package that a mesh's address names is not found.

    RViz shows nothing there, and Gazebo leaves the shape out. A package that is installed elsewhere is found in a sourced
    environment, or by --package-path.
    """
    robot = robot_in(project)
    count: dict[str, int] = {}
    lost = [mesh for mesh in robot.meshes if mesh.file and not mesh.file.package_found] if robot else []
    for mesh in lost:
        package = mesh.file.package if mesh.file else None
        count[package or ""] = count.get(package or "", 0) + 1
    for mesh in lost:
        package = (mesh.file.package if mesh.file else None) or ""
        many = count.pop(package, 0)
        if many and is_known(package):
            hint = f"; did you mean '{mesh.file.nearest}'?" if mesh.file and mesh.file.nearest else ""
            told = f" ({many} meshes)" if many > 1 else ""
            yield Finding(mesh.at, f"package '{package}' of a mesh is not found{told}{hint}")
