"""UC149."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from urdfctl.model.robot import Mesh
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, robot_in


@rule(
    "UC149",
    severity=Severity.WARNING,
    runtime="warns",
    authority="resource_retriever: 'Could not load resource [...]'; urdfdom does not open meshes",
    bad=[
        {
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
def mesh_not_found(project: Project) -> Iterator[Finding]:
    """Mesh file does not exist.

    urdfdom does not open meshes. RViz shows nothing, and Gazebo leaves out the shape, so the link touches nothing. If
    all meshes of a folder are missing, only the first one is reported.
    """
    robot = robot_in(project)
    missing: dict[str, dict[str, Mesh]] = {}
    existing, used = set(), set()
    for mesh in robot.meshes if robot else ():
        folder = mesh.filename.rpartition("/")[0]
        if mesh.file is None or not mesh.file.package_found or not is_known(mesh.filename) or "$(" in mesh.filename:
            continue  # what is left for xacro names no file yet
        if mesh.file.exists:
            existing.add(folder)
            used.add(mesh.filename.rpartition("/")[2])
        else:
            missing.setdefault(folder, {}).setdefault(mesh.filename, mesh)
    for folder, by_name in missing.items():
        meshes = list(by_name.values())
        whole_folder = folder not in existing and len(meshes) > 1
        more = f" (all {len(meshes)} meshes of its folder are missing)" if whole_folder else ""
        for mesh in meshes[:1] if whole_folder else meshes:
            nearest = _meant(mesh, used) if not whole_folder else None
            hint = f"; did you mean '{nearest}'?" if nearest else ""
            problem = f"mesh of {label('link', mesh.link)} does not exist: '{_shown(mesh)}'"
            yield Finding(mesh.at, f"{problem}{more}{hint}")


def _meant(mesh: Mesh, used: Collection[str]) -> str | None:
    """The file that is likely meant: not the mesh of another link, unless only the ending or the case differs."""
    nearest = mesh.file.nearest if mesh.file else None
    stems = {name.rpartition("/")[2].rpartition(".")[0].lower() for name in (nearest or "", mesh.filename)}
    return nearest if nearest not in used or len(stems) == 1 else None


def _shown(mesh: Mesh) -> str:
    """The package:// address in place of a path."""
    return (mesh.file and mesh.file.address) or mesh.filename
