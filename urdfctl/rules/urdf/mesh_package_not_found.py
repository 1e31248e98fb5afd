"""UC150."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Mesh
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import fetched_apart, is_known, robot_in
from urdfctl.rules.urdf.mesh_addresses import in_packages


@rule(
    "UC150",
    severity=Severity.WARNING,
    runtime="warns",
    authority="resource_retriever: 'Package [...] does not exist'; urdfdom does not open meshes",
    bad=[
        {
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
def mesh_package_not_found(project: Project) -> Iterator[Finding]:
    """Mesh package was not found.

    RViz and Gazebo print an error and leave out the shape. For a package that is installed elsewhere, declare it in
    package.xml, source its environment or use --package-path. If a README, a script
    or a list of repositories says how to get it, this is only worth knowing.
    """
    robot = robot_in(project)
    by_package: dict[str, list[Mesh]] = {}
    files = ((mesh, mesh.file) for mesh in (robot.meshes if robot else ()))
    lost = [mesh for mesh, file in files if file and not file.package_found and not file.package_declared]
    for mesh in lost:
        by_package.setdefault((mesh.file.package if mesh.file else None) or "", []).append(mesh)
    for package, meshes in by_package.items():
        file = meshes[0].file
        if file is None or not is_known(package):
            continue
        count = f" ({len(meshes)} meshes)" if len(meshes) > 1 else ""
        if file.meant:
            own = file.meant.split("/")[2]
            message = f"'{package}' is not a package, but a folder of package '{own}'{count}"
        else:
            hint = f"; did you mean '{file.nearest}'?" if file.nearest else ""
            message = f"mesh package '{package}' was not found in this workspace{count}{hint}"
        finding = Finding(meshes[0].at, message, fix=in_packages(meshes))
        yield finding if file.meant or file.nearest else fetched_apart(project, package, finding)
